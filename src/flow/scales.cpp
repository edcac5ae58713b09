#include "flow/scales.hpp"

#include <cmath>

#include "body/extent.hpp"

namespace vortree::flow {
namespace {

/// Along which drag points: down the stream; in fluid at rest the way of a plunge, or against the
/// fastest motion of any body.
Vec2 way_of(const Case& of) {
  const auto [u, v] = of.flow.stream;
  if (u != 0 || v != 0) return {u, v};
  const body::Motion motion = body::motion_of(of.plunge, of.motion);
  if (motion.plunge.frequency > 0) return motion.plunge.amplitude;
  return -1 * body::fastest_velocity(bodies_of(of), of.time.end);
}

/// Not by round-off alone, as the velocity of a course that begins at rest.
bool begins_at_once(const body::Motion& motion, const Scales& scales) {
  constexpr double round_off = 1e-9;
  const body::Kinematics first = motion.at(0);
  const double speed =
      std::sqrt(dot(first.velocity, first.velocity)) + std::abs(first.rate) * scales.length;
  return speed > round_off * scales.speed;
}

}  // namespace

Scales scales_of(const Case& of) {
  Scales scales;
  scales.body = of.body.has_value();
  if (of.body) scales.length = body::length_of(*of.body);
  if (const double speed = speed_of(of); speed > 0) scales.speed = speed;
  if (const auto initial = periodic_flow_of(of))
    scales.length = initial->wavelength, scales.speed = initial->speed;
  if (const Vec2 way = way_of(of); dot(way, way) > 0) scales.along = unit(way);
  scales.impulsive =
      speed_of_stream(of) > 0 || begins_at_once(body::motion_of(of.plunge, of.motion), scales);
  for (const body::BodySettings& one : every_body(of))
    scales.impulsive |= begins_at_once(body::motion_of(std::nullopt, one.motion), scales);
  return scales;
}

}  // namespace vortree::flow
