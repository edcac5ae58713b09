#include "vortex/adapt/lattice/spline_nodes.hpp"

#include <cmath>

#include "vortex/adapt/lattice/lay_onto_lattice.hpp"

namespace vortree::vortex {
namespace {

using Line = std::array<double, SplineNodes::across>;

/// What nodes along a line have of a place, counted from the nearest towards the place's side: the
/// same numbers for mirror images, to the bit.
struct LineOfNodes {
  std::int64_t nearest;
  int side;
  Line share{}, slope{};

  LineOfNodes(double place, double variance) {
    const double node = std::nearbyint(place), t = std::abs(place - node), u = 1 - t;
    const std::array<double, 4> spline{u * u * u / 6, 2.0 / 3 - t * t + t * t * t / 2,
                                       2.0 / 3 - u * u + u * u * u / 2, t * t * t / 6};
    const double c = (variance - 1.0 / 3) / 2;
    const std::array<double, 5> widened{-c / 12, 4 * c / 3, 1 - 2.5 * c, 4 * c / 3, -c / 12};
    constexpr int first = SplineNodes::reach - 1;
    nearest = static_cast<std::int64_t>(node);
    side = place < node ? -1 : 1;
    slope[first] = -u * u / 2;
    slope[first + 1] = (1.5 * t - 2) * t;
    slope[first + 2] = (2 - 1.5 * u) * u;
    slope[first + 3] = t * t / 2;
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < 5; ++b) share[first - 2 + a + b] += widened[b] * spline[a];
  }

  /// Where a node that is counted so stands.
  int at(int counted) const { return SplineNodes::reach + side * (counted - SplineNodes::reach); }
};

}  // namespace

SplineNodes::SplineNodes(Vec2 at, const Core& core, const LatticeLevel& level) {
  const double h2 = level.h * level.h, spread = (core.square - level.square) / 2 / h2;
  const LineOfNodes x(at.x / level.h, spread + core.deviator.xx / h2),
      y(at.y / level.h, spread - core.deviator.xx / h2);
  const double tilt = x.side * y.side * core.deviator.xy / h2;
  gx = x.nearest;
  gy = y.nearest;
  for (int b = 0; b < across; ++b)
    for (int a = 0; a < across; ++a)
      share[x.at(a) + across * y.at(b)] = x.share[a] * y.share[b] + tilt * x.slope[a] * y.slope[b];
}

}  // namespace vortree::vortex
