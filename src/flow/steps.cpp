#include "flow/steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace vortree::flow {
namespace {

constexpr double few_more = 0.02;  // steps, for the sake of frames and pictures

int moments_met(const Case& of, std::span<const double> pictures, double dt) {
  int count = of.output.frames > 0 && met(of.output.frames, dt);
  for (const double t : pictures) count += met(t, dt);
  return count;
}

}  // namespace

bool met(double t, double dt) {
  const double steps = t / dt;
  return std::abs(steps - std::round(steps)) <= moment_slack;
}

long last_step(const TimeSettings& time) {
  return std::max(1L, std::lround(time.end / time.dt));
}

long nearest_step(double t, double dt, long last) {
  return std::lround(std::min(t / dt, static_cast<double>(last) + 1));
}

std::vector<double> picture_times(const OutputSettings& output, double end) {
  std::vector<double> times = output.fields;
  if (!output.fields_every) return times;
  const double from = output.fields_from.value_or(0), every = *output.fields_every;
  const double count = std::min(most_pictures, (end - from) / every * (1 + 1e-12) + moment_slack);
  for (int k = 0; k <= count; ++k) times.push_back(from + k * every);
  return times;
}

double fitted_step(const Case& of, double dt) {
  const double end = of.time.end;
  dt = std::max(dt, std::numeric_limits<double>::min());
  if (!(end / dt <= most_steps)) return dt;  // refused by refuse_uncountable
  const double least = std::max(1.0, std::ceil(end / dt - moment_slack));
  const double more = std::clamp(std::floor(few_more * least), 1.0, 1e5);
  const std::vector<double> pictures = picture_times(of.output, end);
  double best = met(end, dt) && end > dt ? dt : end / least;
  for (double steps = least + 1; steps <= least + more; ++steps)
    if (moments_met(of, pictures, end / steps) > moments_met(of, pictures, best))
      best = end / steps;
  return best;
}

double usual_frames(const TimeSettings& time) {
  return time.dt * std::max(1.0, std::round(time.end / 14 / time.dt));
}

void refuse_uncountable(const TimeSettings& time) {
  if (time.end < time.dt)
    throw Refused("time.end",
                  fmt::format("time.end is {}; it must be >= time.dt = {}", time.end, time.dt));
  if (const double steps = time.end / time.dt; !(steps <= most_steps))
    throw Refused("time.end",
                  fmt::format("time.end is {}, which is {:.3g} steps of time.dt = {}; {:.0e} at "
                              "most are run",
                              time.end, steps, time.dt, most_steps));
}

}  // namespace vortree::flow
