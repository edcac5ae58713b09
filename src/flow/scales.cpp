#include "flow/scales.hpp"

#include "body/extent.hpp"

namespace vortree::flow {

Scales scales_of(const Case& of) {
  Scales scales;
  scales.body = of.body.has_value();
  if (of.body) scales.length = body::length_of(*of.body);
  if (const double speed = speed_of(of); speed > 0) scales.speed = speed;
  if (const auto initial = periodic_flow_of(of))
    scales.length = initial->wavelength, scales.speed = initial->speed;
  const bool stream = speed_of_stream(of) > 0;
  if (stream || of.plunge) {
    const auto [x, y] = stream ? of.flow.stream : of.plunge->direction;
    scales.along = unit(Vec2{x, y});
  }
  scales.impulsive = stream || (of.motion && of.motion->spin != 0);
  return scales;
}

}  // namespace vortree::flow
