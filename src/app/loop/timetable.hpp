#pragma once

#include <vector>

#include "io/scene/scene.hpp"

namespace vortree::app {

/// When a run does what: times are moments k dt, and what a scene asks for at any other time is
/// done at the nearest.
class Timetable {
 public:
  explicit Timetable(const io::Scene& scene);

  long last_step() const { return last_; }  ///< 1 or more
  double time(long step) const { return static_cast<double>(step) * dt_; }

  bool frame_due(long step) const;  ///< at the start, every output.frames, and at the end
  bool field_due(long step) const;

 private:
  double dt_, frames_;  // frames_ in steps
  long last_;
  std::vector<long> fields_;  // ascending
};

}  // namespace vortree::app
