#include "flow/timetable.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "io/scene/time.hpp"

namespace vortree::flow {
namespace {

/// The moment next to t, as a step; one behind the last if it is later.
long nearest_step(double t, double dt, long last) {
  return std::lround(std::min(t / dt, static_cast<double>(last) + 1));
}

}  // namespace

Timetable::Timetable(const io::Scene& scene)
    : dt_(scene.time.dt),
      frames_(scene.output.frames / scene.time.dt),
      last_(std::max(1L, std::lround(scene.time.end / scene.time.dt))) {
  for (const double t : scene.output.fields) fields_.push_back(nearest_step(t, dt_, last_));
}

bool Timetable::frame_due(long step) const {
  if (step == last_) return true;
  const double count = std::round(static_cast<double>(step) / frames_);
  return std::round(count * frames_) == static_cast<double>(step);
}

bool Timetable::field_due(long step) const {
  return std::ranges::find(fields_, step) != fields_.end();
}

std::vector<std::string> warnings_of_times(const io::Scene& scene) {
  std::vector<std::string> list;
  const Timetable table(scene);
  const double dt = scene.time.dt, end = scene.time.end, comes = table.time(table.last_step());
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
    const long step = nearest_step(t, dt, table.last_step());
    if (step > table.last_step())
      beyond.push_back(fmt::format("{:.9g}", t));
    else if (!io::met(t, dt))
      moved.push_back(fmt::format("{:.9g} at t = {:.9g}", t, table.time(step)));
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

}  // namespace vortree::flow
