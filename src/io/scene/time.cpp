#include "io/scene/time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vortree::io {
namespace {

constexpr double few_more = 0.02;  // steps, for the sake of frames and pictures

int moments_met(const Scene& scene, double dt) {
  int count = scene.output.frames > 0 && met(scene.output.frames, dt);
  for (const double t : scene.output.fields) count += met(t, dt);
  return count;
}

}  // namespace

bool met(double t, double dt) {
  const double steps = t / dt;
  return std::abs(steps - std::round(steps)) <= moment_slack;
}

long last_step(const flow::TimeSettings& time) {
  return std::max(1L, std::lround(time.end / time.dt));
}

long nearest_step(double t, double dt, long last) {
  return std::lround(std::min(t / dt, static_cast<double>(last) + 1));
}

double fitted_step(const Scene& scene, double dt) {
  const double end = scene.time.end;
  dt = std::max(dt, std::numeric_limits<double>::min());
  if (!(end / dt <= most_steps)) return dt;  // refused by check_time
  const double least = std::max(1.0, std::ceil(end / dt - moment_slack));
  const double more = std::clamp(std::floor(few_more * least), 1.0, 1e5);
  double best = met(end, dt) && end > dt ? dt : end / least;
  for (double steps = least + 1; steps <= least + more; ++steps)
    if (moments_met(scene, end / steps) > moments_met(scene, best)) best = end / steps;
  return best;
}

double usual_frames(const flow::TimeSettings& time) {
  return time.dt * std::max(1.0, std::round(time.end / 14 / time.dt));
}

void check_time(const Document& document, const flow::TimeSettings& time) {
  if (time.end < time.dt)
    document.refuse("time.end",
                    fmt::format("time.end is {}; it must be >= time.dt = {}", time.end, time.dt));
  if (const double steps = time.end / time.dt; !(steps <= most_steps))
    document.refuse("time.end",
                    fmt::format("time.end is {}, which is {:.3g} steps of time.dt = {}; {:.0e} at "
                                "most are run",
                                time.end, steps, time.dt, most_steps));
}

}  // namespace vortree::io
