#include "sph/boundary/open_boundary.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "body/shapes/circle.hpp"
#include "sph/boundary/wall_nodes.hpp"
#include "sph/operators/clouds.hpp"

using namespace vortree;
using namespace vortree::sph;
using namespace vortree::sph::test;

namespace {

constexpr double s = 0.1;
const OuterBox box{{-1, -1}, {1, 1}};

/// Fluid of spacing s in the box, with nodes around it; all carry a polynomial of degree 2.
struct InBox {
  Cloud cloud;
  std::shared_ptr<const body::Shape> shape;
  Confines confines{box};
  Stencils stencils;
  std::vector<Slopes> slopes;

  explicit InBox(bool body = false) {
    Cloud fluid = lattice(box.low, box.high, s);
    if (body) add_body(fluid);
    for (std::size_t i = 0; i < fluid.size(); ++i)
      if (!body || shape->distance(fluid.at(i)) > 0.2)
        cloud.add(fluid.at(i), s, ParticleKind::fluid);
    std::int32_t number = 0;
    for (const BoundaryNode& node : box_nodes(box, s))
      cloud.add(node, node.normal.x < 0 ? ParticleKind::outlet : ParticleKind::outer, number++);
    see();
  }

  static double field(Vec2 at) { return 1 + at.x - at.y * at.y + 0.5 * at.x * at.y; }

  void see() {
    cloud.u = values(cloud, field);
    stencils.renew(cloud, {});
    find_slopes(cloud, stencils, slopes);
  }

  Population population() { return {cloud, stencils, slopes}; }

 private:
  void add_body(Cloud&) {
    shape = body::circle({}, 0.3);
    confines = {box, StandingBodies({{.shape = shape, .nodes = 19, .spacing = s}}), 1};
    for (const BoundaryNode& node : ring_nodes(*shape, s, s, false))
      cloud.add(node, ParticleKind::ring, 1);
  }
};

std::size_t free_count(const Cloud& cloud) {
  return static_cast<std::size_t>(std::ranges::count(cloud.kind, ParticleKind::fluid));
}

double apart(Vec2 a, Vec2 b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

}  // namespace

TEST_CASE("a lattice in its box has no gaps, and nobody who has to go") {
  for (const bool body : {false, true}) {
    InBox of(body);
    const Cloud before = of.cloud;
    Population population = of.population();
    take_away(population, of.confines);
    if (!body) fill_gaps(population, of.confines);
    population.finish();
    CHECK(of.cloud.x == before.x);
  }
}

TEST_CASE("particles nearer to the outer boundary than 0.35 s are taken away") {
  InBox of;
  std::vector<std::size_t> expected;
  for (std::size_t i = 0; i < of.cloud.size(); ++i) {
    if (!of.cloud.free(i)) continue;
    of.cloud.x[i] += 0.25 * s;  // those to the right now stand 0.25 s inside
    if (of.cloud.x[i] > 1 - 0.35 * s) expected.push_back(i);
  }
  Population population = of.population();
  take_away(population, of.confines);
  CHECK(expected.size() == 20);
  for (const std::size_t i : expected) CHECK(population.gone(i));
  population.finish();
  CHECK(free_count(of.cloud) == 400 - 20);
}

TEST_CASE("particles beyond the box, or among the rings, or in the body, are taken away") {
  InBox of(true);
  std::vector<std::size_t> moved;
  for (std::size_t i = 0; i < of.cloud.size(); ++i)
    if (of.cloud.free(i)) moved.push_back(i);
  of.cloud.x[moved[0]] = 1.3;                                        // beyond
  of.cloud.x[moved[1]] = 0, of.cloud.y[moved[1]] = 0.3 + 1.44 * s;   // near the ring
  of.cloud.x[moved[2]] = 0.1, of.cloud.y[moved[2]] = 0;              // in the body
  of.cloud.x[moved[3]] = 0, of.cloud.y[moved[3]] = -0.3 - 1.46 * s;  // just not
  Population population = of.population();
  take_away(population, of.confines);
  CHECK(population.gone(moved[0]));
  CHECK(population.gone(moved[1]));
  CHECK(population.gone(moved[2]));
  CHECK_FALSE(population.gone(moved[3]));
}

TEST_CASE("of two that are too close the smaller goes, or of equals one") {
  for (const double share : {0.9, 1.0, 1.1}) {
    InBox of;
    const std::size_t i = 210, j = 211;  // neighbors in the middle
    REQUIRE(apart(of.cloud.at(i), of.cloud.at(j)) < 1.1 * s);
    of.cloud.y[i] = of.cloud.y[j] - 0.35 * s;
    of.cloud.spacing[j] *= share;
    of.see();
    Population population = of.population();
    take_away(population, of.confines);
    CHECK(population.gone(i) + population.gone(j) == 1);
    if (share != 1.0) CHECK(population.gone(share < 1 ? j : i));
    population.finish();
    CHECK(free_count(of.cloud) == 399);
  }
}

TEST_CASE("gaps beside the box are filled, and only those, with what the boundary carries") {
  InBox of;
  for (std::size_t i = 0; i < of.cloud.size(); ++i)
    if (of.cloud.free(i)) of.cloud.x[i] += 0.9 * s;  // room to the left; a column is gone
  of.see();
  Population population = of.population();
  take_away(population, of.confines);
  const std::size_t old = of.cloud.size();
  fill_gaps(population, of.confines);
  // One beside each of 19 nodes that are no corners; below and above, beside none.
  REQUIRE(of.cloud.size() == old + 19);
  for (std::size_t k = old; k < of.cloud.size(); ++k) {
    CHECK(of.cloud.free(k));
    CHECK(of.cloud.x[k] == Approx(-1 + 0.75 * s).epsilon(1e-12));
    CHECK(of.cloud.spacing[k] == Approx(s).epsilon(1e-12));
    CHECK(of.cloud.u[k] == Approx(InBox::field(of.cloud.at(k))).margin(1e-10));
  }
  population.finish();
  // Nobody stands nearer to another than the births' own distance allows.
  for (std::size_t i = 0; i < of.cloud.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (of.cloud.free(i) && of.cloud.free(j))
        REQUIRE(apart(of.cloud.at(i), of.cloud.at(j)) > 0.8 * s);
}

TEST_CASE("gaps beside the outermost ring are filled a spacing away from it") {
  InBox of(true);
  Cloud& cloud = of.cloud;
  std::vector<char> gone(cloud.size(), 0);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    gone[i] = cloud.free(i) && of.shape->distance(cloud.at(i)) < 0.35;
  cloud.remove(gone);
  of.see();
  Population population = of.population();
  const std::size_t old = cloud.size();
  fill_gaps(population, of.confines);
  CHECK(cloud.size() > old + 15);
  for (std::size_t k = old; k < cloud.size(); ++k) {
    CHECK(of.shape->distance(cloud.at(k)) == Approx(2 * s).epsilon(1e-9));
    for (std::size_t j = old; j < k; ++j) CHECK(apart(cloud.at(j), cloud.at(k)) > 0.8 * s * 0.99);
  }
}
