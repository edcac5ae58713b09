#include "body/travel.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "body/extent.hpp"
#include "body/outlines/shape_group.hpp"

namespace vortree::body {
namespace {

constexpr int moments = 1000;  // of a run, in which places of bodies are looked at

}  // namespace

FastestMoves::FastestMoves(const Course& course) {
  for (const double t : course.times()) {
    const Kinematics now = course.at(t);
    speed = std::max(speed, std::hypot(now.velocity.x, now.velocity.y));
    acceleration = std::max(acceleration, std::hypot(now.acceleration.x, now.acceleration.y));
    rate = std::max(rate, std::abs(now.rate));
    spin_up = std::max(spin_up, std::abs(now.spin_up));
  }
}

double FastestMoves::period() const {
  const double travel = acceleration > 0 ? speed / acceleration : INFINITY;
  const double turn = spin_up > 0 ? rate / spin_up : INFINITY;
  return 2 * std::numbers::pi * std::min(travel, turn);
}

Vec2 fastest_velocity(const Bodies& bodies, double end) {
  Vec2 fastest;
  for (const Body& one : bodies) {
    std::vector<double> times(one.motion.course.times().begin(), one.motion.course.times().end());
    times.insert(times.end(), one.own.course.times().begin(), one.own.course.times().end());
    for (int k = 0; one.motion.plunge.frequency > 0 && k <= moments; ++k)
      times.push_back(end * k / moments);
    for (const double t : times)
      if (const Vec2 v = one.motion.at(t).velocity + one.own.at(t).velocity;
          dot(v, v) > dot(fastest, fastest))
        fastest = v;
  }
  return fastest;
}

namespace {

Vec2 centre_at(const Body& body, double t) {
  return body.centre + body.own.at(t).place;
}

/// As it stands at a time in the frame of all.
PlacedShape placed(const Body& body, double t) {
  return {body.shape, centre_at(body, t), body.own.at(t).angle};
}

/// Times at which their centres are too far apart for it are passed over.
NearestApproach meeting(const Bodies& bodies, std::size_t a, std::size_t b, double end) {
  const double radii = farthest_of(*bodies[a].shape) + farthest_of(*bodies[b].shape);
  const bool moves = bodies[a].own.course.moves() || bodies[b].own.course.moves();
  NearestApproach nearest{a, b, INFINITY, 0};
  for (int k = 0; k <= (moves ? moments : 0); ++k) {
    const double t = end * k / moments;
    const Vec2 way = centre_at(bodies[a], t) - centre_at(bodies[b], t);
    if (std::sqrt(dot(way, way)) - radii >= nearest.gap) continue;
    const double gap = gap_between(placed(bodies[a], t), placed(bodies[b], t));
    if (gap < nearest.gap) nearest.gap = gap, nearest.time = t;
  }
  return nearest;
}

}  // namespace

std::vector<NearestApproach> meetings(const Bodies& bodies, double end) {
  std::vector<NearestApproach> all;
  for (std::size_t b = 1; b < bodies.size(); ++b)
    for (std::size_t a = 0; a < b; ++a) all.push_back(meeting(bodies, a, b, end));
  return all;
}

std::array<double, 4> place_of(const Body& body, double end) {
  std::array<double, 2> half = half_extent(*body.shape);
  if (body.own.course.turns()) half[0] = half[1] = farthest_of(*body.shape);
  std::array<double, 4> all{INFINITY, INFINITY, -INFINITY, -INFINITY};
  for (int k = 0; k <= (body.own.course.moves() ? moments : 0); ++k) {
    const Vec2 at = centre_at(body, end * k / moments);
    all = {std::min(all[0], at.x - half[0]), std::min(all[1], at.y - half[1]),
           std::max(all[2], at.x + half[0]), std::max(all[3], at.y + half[1])};
  }
  return all;
}

}  // namespace vortree::body
