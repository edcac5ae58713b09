#include "flow/scales.hpp"

#include <cmath>

#include "body/extent.hpp"

namespace vortree::flow {
namespace {

Vec2 unit(const Pair& a) {
  return (1 / std::hypot(a[0], a[1])) * Vec2{a[0], a[1]};
}

}  // namespace

Scales scales_of(const Case& of) {
  Scales scales;
  scales.body = of.body.has_value();
  if (of.body) scales.length = body::length_of(*of.body);
  if (const double speed = speed_of(of); speed > 0) scales.speed = speed;
  const bool stream = speed_of_stream(of) > 0;
  if (stream)
    scales.along = unit(of.flow.stream);
  else if (of.plunge)
    scales.along = unit(of.plunge->direction);
  scales.impulsive = stream || (of.motion && of.motion->spin != 0);
  return scales;
}

}  // namespace vortree::flow
