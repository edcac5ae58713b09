#include "sph/operators/sight.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <numbers>
#include <set>
#include <utility>

#include "body/shapes/circle.hpp"
#include "body/shapes/naca0012.hpp"
#include "sph/boundary/wall_nodes.hpp"
#include "sph/operators/derivatives.hpp"
#include "tree/neighbors/neighbors.hpp"

using namespace vortree;
using namespace vortree::sph;

namespace {

/// A foil with its chord from -0.5 to 0.5 along x, whose rear end is 0.01 wide and round.
const std::shared_ptr<const body::Shape>& foil() {
  static const std::shared_ptr<const body::Shape> shape = body::naca0012({}, 1, 0.005, 0);
  return shape;
}

/// Nodes and three rings around a body, of which the outer ones may be free.
Cloud rings_around(const body::Shape& shape, double s, int still = 3) {
  Cloud cloud;
  std::int32_t number = 0;
  for (const BoundaryNode& node :
       wall_nodes(shape, static_cast<int>(std::lround(shape.perimeter() / s))))
    cloud.add(node, ParticleKind::wall, number++);
  for (int ring = 1; ring <= 3; ++ring)
    for (const BoundaryNode& node : ring_nodes(shape, ring * s, s, ring % 2 == 0))
      ring <= still ? cloud.add(node, ParticleKind::ring, ring)
                    : cloud.add(node.at, s, ParticleKind::fluid);
  return cloud;
}

tree::PairList pairs_of(const Cloud& cloud, double reach) {
  const std::vector<double> reaches(cloud.size(), reach);
  return tree::neighbors(cloud.points(), reaches, tree::PairRule::mean);
}

using Pairs = std::set<std::pair<std::size_t, std::size_t>>;

Pairs all_of(const tree::PairList& rows) {
  Pairs pairs;
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const std::int32_t j : rows.row(i)) pairs.emplace(i, j);
  return pairs;
}

}  // namespace

TEST_CASE("a thin body hides what is behind it, and not what is beside it or past its end") {
  const body::Shape& shape = *foil();
  // Near the rear end, the body is 0.02 thick.
  CHECK(hidden(shape, {0.43, 0.03}, {0.43, -0.03}));
  CHECK(hidden(shape, {0.43, 0.03}, {0.40, -0.025}));
  CHECK(hidden(shape, {0.43, -0.03}, {0.43, 0.03}));
  CHECK_FALSE(hidden(shape, {0.43, 0.03}, {0.40, 0.03}));
  CHECK_FALSE(hidden(shape, {0.52, 0.03}, {0.52, -0.03}));
  CHECK_FALSE(hidden(shape, {0.49, 0.04}, {0.53, -0.02}));
  // From the wall itself through the body, along it, and away from it.
  const Vec2 above = shape.point(0.1), below = shape.point(shape.perimeter() - 0.1);
  CHECK(above.y * below.y < 0);
  CHECK(hidden(shape, above, below));
  CHECK_FALSE(hidden(shape, above, shape.point(0.12)));
  CHECK_FALSE(hidden(shape, above, {above.x, 3 * above.y}));
}

TEST_CASE("nodes of a bend see each other though their chord cuts it") {
  const auto circle = body::circle({}, 0.5);
  for (const double angle : {0.05, 0.3, 1.0, 1.5})
    CHECK_FALSE(hidden(*circle, circle->point(0), circle->point(0.5 * angle)));
  CHECK(hidden(*circle, circle->point(0), circle->point(0.5 * 1.6)));
  CHECK(hidden(*circle, {0.6, 0}, {-0.6, 0.1}));
}

TEST_CASE("lists around a foil lose the pairs that it stands between, both ways, and no other") {
  const double s = 0.02;
  const int still = GENERATE(0, 1, 3);  // those beyond are free, and asked as well
  CAPTURE(still);
  const Cloud cloud = rings_around(*foil(), s, still);
  tree::PairList rows = pairs_of(cloud, 2.8 * s);
  const Pairs before = all_of(rows);
  keep_in_sight(rows, cloud, *foil(), 2.8);
  const Pairs after = all_of(rows);
  std::size_t lost = 0, wrong = 0;
  for (const auto& [i, j] : before) {
    const bool stays = after.contains({i, j});
    // Chords of a dozen pieces: a place inside the body and ends on both sides of it.
    bool cut = false;
    for (int k = 1; k < 400; ++k)
      cut = cut || foil()->distance(cloud.at(i) + k / 400.0 * (cloud.at(j) - cloud.at(i))) < -1e-4;
    const bool opposite =
        dot(foil()->nearest(cloud.at(i)).normal, foil()->nearest(cloud.at(j)).normal) < -0.5;
    if (!stays) ++lost;
    if (cut && opposite && stays) ++wrong;
    if (!cut && !stays) ++wrong;
    CHECK(stays == after.contains({j, i}));
  }
  CHECK(lost > 0);
  CHECK(wrong == 0);
  CHECK(after.size() + lost == before.size());
}

TEST_CASE("around a thick body nothing is lost") {
  const auto circle = body::circle({}, 0.5);
  const Cloud cloud = rings_around(*circle, 0.1);
  tree::PairList rows = pairs_of(cloud, 0.28);
  const Pairs before = all_of(rows);
  keep_in_sight(rows, cloud, *circle, 2.8);
  CHECK(all_of(rows) == before);
}

TEST_CASE("velocities on both sides of a thin body do not mix") {
  // Fluid above goes to the right, below to the left; nothing is sheared but past the end.
  const double s = 0.0125;
  Cloud cloud = rings_around(*foil(), s);
  for (std::size_t i = 0; i < cloud.size(); ++i) cloud.u[i] = cloud.y[i] > 0 ? 1 : -1;
  Stencils blind, seeing;
  blind.renew(cloud, {2, 2.8, 0, nullptr});
  seeing.renew(cloud, {2, 2.8, 0, foil().get()});
  std::vector<Slopes> mixed, kept;
  find_slopes(cloud, blind, mixed), find_slopes(cloud, seeing, kept);
  double worst = 0, without = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (cloud.x[i] < 0.25 || cloud.x[i] > 0.5 - 4 * s) continue;
    worst = std::max(worst, std::abs(kept[i][0].y));
    without = std::max(without, std::abs(mixed[i][0].y));
  }
  CHECK(worst < 1e-9 / s);  // fits of a constant, to round-off
  CHECK(without > 0.1 / s);
}
