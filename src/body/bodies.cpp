#include "body/bodies.hpp"

namespace vortree::body {

Motion motion_of(const std::optional<PlungeSettings>& plunge,
                 const std::optional<MotionSettings>& motion) {
  Motion of;
  if (plunge) {
    const auto [x, y] = plunge->direction;
    of.plunge = {plunge->amplitude * unit(Vec2{x, y}), plunge->frequency};
  }
  if (motion) of.spin = {motion->spin}, of.course = motion->course;
  return of;
}

}  // namespace vortree::body
