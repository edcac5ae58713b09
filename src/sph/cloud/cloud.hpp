#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec2.hpp"
#include "tree/order/points.hpp"

namespace vortree::sph {

/// fluid   free: moves with the flow
/// ring    fluid that stands still beside a body: its fields come to it
/// wall    a node of a body's outline
/// outer   a node of the outer boundary where the velocity is given
/// outlet  one through which fluid leaves
enum class ParticleKind : std::uint8_t { fluid, ring, wall, outer, outlet };

/// A node of a boundary.
///
/// normal   unit, into the fluid
/// spacing  length of boundary that is its own [L]
struct BoundaryNode {
  Vec2 at, normal;
  double spacing = 0;
};

/// Particles of incompressible SPH: where they are, how much of the plane is theirs, and what they
/// carry.
///
/// spacing            s [L]; a particle's volume is s^2
/// place              wall: number along all bodies, each anticlockwise; ring: 1 beside the wall,
///                    2, ...; outer and outlet: number around the box; else 0
/// nx, ny             normal of a node into the fluid, of a ring away from its body; else 0
/// u, v               velocity at the time t [L/T]; u_before, v_before at the time of the step
///                    before, of the same fluid
/// p                  pressure per unit density at t [L^2/T^2]
/// was                its number when particles were numbered last; -1: it is new
struct Cloud {
  std::vector<double> x, y, spacing;
  std::vector<ParticleKind> kind;
  std::vector<std::int32_t> place;
  std::vector<double> nx, ny;
  std::vector<double> u, v, u_before, v_before, p;
  std::vector<std::int32_t> was;

  [[nodiscard]] std::size_t size() const { return x.size(); }
  [[nodiscard]] tree::Points points() const { return {x, y}; }
  [[nodiscard]] Vec2 at(std::size_t i) const { return {x[i], y[i]}; }
  [[nodiscard]] Vec2 normal(std::size_t i) const { return {nx[i], ny[i]}; }
  [[nodiscard]] Vec2 velocity(std::size_t i) const { return {u[i], v[i]}; }
  [[nodiscard]] double volume(std::size_t i) const { return spacing[i] * spacing[i]; }

  /// The equations of motion hold there.
  [[nodiscard]] bool inside(std::size_t i) const { return kind[i] <= ParticleKind::ring; }
  [[nodiscard]] bool free(std::size_t i) const { return kind[i] == ParticleKind::fluid; }
  /// It stands still and the flow passes through it.
  [[nodiscard]] bool passed(std::size_t i) const {
    return kind[i] == ParticleKind::ring || kind[i] == ParticleKind::outlet;
  }

  /// Adds one that carries nothing yet, and returns its number.
  std::size_t add(Vec2 at, double spacing, ParticleKind kind);
  std::size_t add(const BoundaryNode& node, ParticleKind kind, std::int32_t place);

  /// Takes the chosen ones away; the others keep their order.
  void remove(std::span<const char> gone);

  /// The i-th becomes what the order[i]-th was.
  void reorder(std::span<const std::uint32_t> order);
};

/// What particles carry along, in the order of Derivatives.
inline constexpr std::array carried{&Cloud::u, &Cloud::v, &Cloud::u_before, &Cloud::v_before,
                                    &Cloud::p};
inline constexpr std::size_t carried_count = carried.size();

/// The same place within 0 and the period; as it is if that is 0.
[[nodiscard]] double wrapped(double x, double period);

/// A distance to the nearest of all that are a whole number of periods away; as it is if the period
/// is 0.
[[nodiscard]] inline Vec2 nearest_image(Vec2 apart, double period) {
  if (period == 0) return apart;
  return apart - period * Vec2{std::round(apart.x / period), std::round(apart.y / period)};
}

/// Puts particles back into the periodic square from the origin to (period, period); leaves them
/// if that is 0.
void wrap(Cloud& cloud, double period);

/// The nodes of a boundary, by their places.
[[nodiscard]] std::vector<std::uint32_t> in_order(const Cloud& cloud, ParticleKind kind);

/// Numbers the particles as they stand.
void number(Cloud& cloud);

/// Puts the particles into Morton order, in which those near in space are near in memory.
void sort(Cloud& cloud);

}  // namespace vortree::sph
