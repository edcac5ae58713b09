#include "app/loop/timetable.hpp"

#include <algorithm>
#include <cmath>

#include "flow/steps.hpp"

namespace vortree::app {

Timetable::Timetable(const io::Scene& scene)
    : dt_(scene.time.dt),
      frames_(scene.output.frames / scene.time.dt),
      last_(flow::last_step(scene.time)) {
  for (const double t : flow::picture_times(scene.output, scene.time.end))
    fields_.push_back(flow::nearest_step(t, dt_, last_));
  std::ranges::sort(fields_);
}

bool Timetable::frame_due(long step) const {
  if (step == last_) return true;
  const double count = std::round(static_cast<double>(step) / frames_);
  return std::round(count * frames_) == static_cast<double>(step);
}

bool Timetable::field_due(long step) const {
  return std::ranges::binary_search(fields_, step);
}

}  // namespace vortree::app
