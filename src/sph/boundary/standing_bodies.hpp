#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/vec2.hpp"
#include "body/shape.hpp"

namespace vortree::sph {

/// One of the bodies of a flow, none of which moves against another, but that a circle may turn in
/// its place. All as seen from the centre of the first.
///
/// shape    its outline where it stands
/// centre   about which it turns, and its moments are told
/// spin     at which it turns, anticlockwise [1/T]
/// area     [L^2]
/// nodes    of its wall, at equal steps of the arc
/// spacing  between them [L]
/// first    the number of the first among those of all bodies
struct StandingBody {
  std::shared_ptr<const body::Shape> shape;
  Vec2 centre{};
  double spin = 0, area = 0;
  int nodes = 0;
  double spacing = 0;
  std::size_t first = 0;

  /// Of the body, as if it were fluid that turns: that of a vortex in its centre.
  [[nodiscard]] double circulation() const { return 2 * spin * area; }
  [[nodiscard]] Vec2 wall_velocity(Vec2 at) const { return spin * left_of(at - centre); }
  [[nodiscard]] Vec2 wall_acceleration(Vec2 at) const { return -spin * spin * (at - centre); }

  /// Of values of all nodes, those of this body; none if there are none.
  [[nodiscard]] std::span<const double> of(std::span<const double> values) const {
    if (values.empty()) return values;
    return values.subspan(first, static_cast<std::size_t>(nodes));
  }
};

/// A body whose nodes are about `spacing` apart.
///
/// shape  as seen from its own centre
[[nodiscard]] StandingBody stand(std::shared_ptr<const body::Shape> shape, double spacing,
                                 Vec2 centre = {}, double spin = 0);

/// Bodies and their nodes, one body after another; or none.
class StandingBodies {
 public:
  StandingBodies() = default;
  explicit StandingBodies(std::vector<StandingBody> bodies);

  [[nodiscard]] bool empty() const { return bodies_.empty(); }
  [[nodiscard]] std::size_t size() const { return bodies_.size(); }
  [[nodiscard]] auto begin() const { return bodies_.begin(); }
  [[nodiscard]] auto end() const { return bodies_.end(); }
  [[nodiscard]] const StandingBody& operator[](std::size_t k) const { return bodies_[k]; }

  /// The outline of all; null without a body.
  [[nodiscard]] const std::shared_ptr<const body::Shape>& shape() const { return shape_; }
  [[nodiscard]] double area() const;
  [[nodiscard]] std::vector<int> nodes_of_each() const;

  /// The number of the body that has this node of all.
  [[nodiscard]] std::size_t of_node(std::int32_t node) const {
    std::size_t k = 0;
    while (k + 1 < size() && static_cast<std::size_t>(node) >= bodies_[k + 1].first) ++k;
    return k;
  }
  /// Of a wall at one of its nodes; 0 without a body.
  [[nodiscard]] Vec2 wall_velocity(std::int32_t node, Vec2 at) const {
    return empty() ? Vec2{} : bodies_[of_node(node)].wall_velocity(at);
  }

  /// The body whose wall is nearest to a place.
  [[nodiscard]] const StandingBody& nearest(Vec2 at) const;
  /// Whether a place is nearer to a body than so many of its nodes' spacings.
  [[nodiscard]] bool within(Vec2 at, double spacings) const;

  /// Shares of a circulation that belongs to all bodies together, by their perimeters.
  [[nodiscard]] std::vector<double> shared(double circulation) const;

 private:
  std::vector<StandingBody> bodies_;
  std::shared_ptr<const body::Shape> shape_;
};

}  // namespace vortree::sph
