#include "checks/warnings/warnings_of_times.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "io/scene/time.hpp"

namespace vortree::checks {

std::vector<std::string> warnings_of_times(const io::Scene& scene) {
  std::vector<std::string> list;
  const long last = io::last_step(scene.time);
  const double dt = scene.time.dt, end = scene.time.end, comes = static_cast<double>(last) * dt;
  if (!io::met(end, dt))
    list.push_back(fmt::format(
        "time.end = {:.9g} is no multiple of time.dt = {:.9g}: the run ends at t = {:.9g}; "
        "time.dt = {:.9g} meets it",
        end, dt, comes, end / std::ceil(end / dt)));
  if (scene.output.frames < comes && !io::met(scene.output.frames, dt))
    list.push_back(fmt::format(
        "output.frames = {:.9g} is no multiple of time.dt = {:.9g}: each frame is that of the "
        "nearest step, up to {:.2g} off",
        scene.output.frames, dt, dt / 2));
  std::vector<std::string> moved, beyond;
  for (const double t : scene.output.fields) {
    const long step = io::nearest_step(t, dt, last);
    if (step > last)
      beyond.push_back(fmt::format("{:.9g}", t));
    else if (!io::met(t, dt))
      moved.push_back(fmt::format("{:.9g} at t = {:.9g}", t, static_cast<double>(step) * dt));
  }
  if (!moved.empty())
    list.push_back(
        fmt::format("output.fields that are no multiples of time.dt = {:.9g} are drawn, and named, "
                    "at the nearest step: {}",
                    dt, fmt::join(moved, ", ")));
  if (!beyond.empty())
    list.push_back(fmt::format("output.fields = {}: beyond the end, t = {:.9g}; no picture",
                               fmt::join(beyond, ", "), comes));
  return list;
}

}  // namespace vortree::checks
