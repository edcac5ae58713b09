#include "flow/paths/flow_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace vortree::flow {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double fastest(std::span<const VelocityPicture> pictures) {
  double square = 0;
  for (const VelocityPicture& one : pictures)
    for (const Vec2 u : one.velocity) square = std::max(square, dot(u, u));
  return std::sqrt(square);
}

/// The velocity at the beginning, in the middle and at the end of a step.
struct StepPictures {
  VelocityPicture begin, middle, end;
  double dt() const { return end.time - begin.time; }
};

/// A step of Runge and Kutta; nothing if one of its places has no velocity.
std::optional<Vec2> stepped(Vec2 x, const StepPictures& step, const VelocityAnywhere& velocity) {
  const double dt = step.dt();
  const auto a = velocity(step.begin, x);
  if (!a) return std::nullopt;
  const auto b = velocity(step.middle, x + dt / 2 * *a);
  if (!b) return std::nullopt;
  const auto c = velocity(step.middle, x + dt / 2 * *b);
  if (!c) return std::nullopt;
  const auto d = velocity(step.end, x + dt * *c);
  if (!d) return std::nullopt;
  return x + dt / 6 * (*a + 2 * *b + 2 * *c + *d);
}

/// All that are not lost; each by itself.
void step_all(std::vector<Vec2>& places, const StepPictures& step,
              const VelocityAnywhere& velocity) {
  const auto n = std::ssize(places);
#pragma omp parallel for schedule(dynamic, 1024)
  for (std::ptrdiff_t k = 0; k < n; ++k)
    if (!std::isnan(places[k].x))
      places[k] = stepped(places[k], step, velocity).value_or(Vec2{nan, nan});
}

}  // namespace

std::vector<double> steps_between(std::span<const VelocityPicture> pictures, double spacing,
                                  double from, double to) {
  std::vector<double> stops{from, to};
  for (const VelocityPicture& one : pictures)
    if (one.time > std::min(from, to) && one.time < std::max(from, to)) stops.push_back(one.time);
  std::ranges::sort(stops);
  if (to < from) std::ranges::reverse(stops);
  const double speed = fastest(pictures);
  std::vector<double> times{from};
  for (std::size_t k = 1; k < stops.size(); ++k) {
    const double way = stops[k] - stops[k - 1];
    const double count = std::max(1.0, std::ceil(std::abs(way) * speed / spacing));
    for (double i = 1; i < count; ++i) times.push_back(stops[k - 1] + way * i / count);
    times.push_back(stops[k]);
  }
  return times;
}

std::vector<Vec2> flow_map(std::vector<Vec2> places, std::span<const VelocityPicture> pictures,
                           const VelocityAnywhere& velocity, double from, double to) {
  const std::vector<double> times = steps_between(pictures, velocity.grid().spacing, from, to);
  StepPictures step{.begin = {}, .middle = {}, .end = between(pictures, from)};
  // Who begins where there is no velocity goes nowhere, not even in no time.
  for (Vec2& place : places)
    if (!velocity(step.end, place)) place = {nan, nan};
  for (std::size_t k = 1; k < times.size(); ++k) {
    step.begin = std::exchange(step.end, between(pictures, times[k]));
    step.middle = between(pictures, (times[k - 1] + times[k]) / 2);
    step_all(places, step, velocity);
  }
  return places;
}

}  // namespace vortree::flow
