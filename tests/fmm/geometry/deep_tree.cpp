#include "fmm/geometry/deep_tree.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "fmm/grown.hpp"

using namespace vortree;
using test::Grown;

namespace {

/// Children lie side by side in their parent: one level deeper, their quadrants ascending, and
/// their points are the parent's, one after the other.
bool families_add_up(const fmm::DeepTree& tree) {
  bool holds = true;
  const auto cells = tree.cells();
  for (std::size_t c = 0; c < cells.size(); ++c) {
    std::uint32_t next = cells[c].points.first;
    int quadrant = -1;
    for (std::uint32_t k = cells[c].children.first; k < cells[c].children.last; ++k) {
      const fmm::DeepCell& child = cells[k];
      holds = holds && child.parent == static_cast<int>(c) && child.level == cells[c].level + 1 &&
              child.quadrant > quadrant && child.points.first == next && !child.points.empty();
      next = child.points.last, quadrant = child.quadrant;
    }
    holds = holds && (cells[c].childless() || next == cells[c].points.last);
  }
  return holds;
}

bool levels_add_up(const fmm::DeepTree& tree) {
  bool holds = tree.level(0) == tree::Range{0, 1};
  std::uint32_t next = 0;
  for (int level = 0; level <= tree.depth(); ++level) {
    holds = holds && tree.level(level).first == next && !tree.level(level).empty();
    next = tree.level(level).last;
    for (std::uint32_t c = tree.level(level).first; c < next; ++c) {
      holds = holds && tree.cells()[c].level == level;
    }
  }
  return holds && next == tree.cells().size();
}

/// Childless cells by rank hold all points, in order.
bool ranks_add_up(const Grown& grown) {
  std::uint32_t next = 0;
  bool holds = true;
  for (const std::uint32_t c : grown.tree.childless()) {
    const fmm::DeepCell& cell = grown.tree.cells()[c];
    holds = holds && cell.childless() && cell.points.first == next;
    next = cell.points.last;
  }
  std::vector<std::uint32_t> order(grown.tree.order().begin(), grown.tree.order().end());
  std::ranges::sort(order);
  for (std::uint32_t j = 0; j < order.size(); ++j) holds = holds && order[j] == j;
  return holds && next == grown.places.x.size();
}

/// Centres are the parent's, plus or minus a quarter of its side, to 100 bits of the root's side.
double worst_centre(const fmm::DeepTree& tree) {
  double worst = 0.0;
  for (std::size_t c = 1; c < tree.cells().size(); ++c) {
    const fmm::DeepCell& cell = tree.cells()[c];
    const fmm::CellFrame &own = tree.frame(c), &above = tree.frame(cell.parent);
    const test::Quad quarter = above.side / 4;
    const test::Quad dx = test::centre_x(own) - test::centre_x(above);
    const test::Quad dy = test::centre_y(own) - test::centre_y(above);
    worst = std::max({worst, test::magnitude(dx - (cell.quadrant % 2 == 0 ? -quarter : quarter)),
                      test::magnitude(dy - (cell.quadrant / 2 == 0 ? -quarter : quarter)),
                      std::abs(own.side - above.side / 2) * 1e60,
                      std::abs(own.side - tree.side(cell.level)) * 1e60});
  }
  return worst / tree.frame(0).side;
}

/// How far outside its cell a point lies, at worst, in sides of the cell.
double worst_place(const Grown& grown) {
  double worst = 0.0;
  for (std::size_t c = 0; c < grown.tree.cells().size(); ++c) {
    const fmm::CellFrame& at = grown.tree.frame(c);
    const tree::Range points = grown.tree.cells()[c].points;
    for (std::uint32_t j = points.first; j < points.last; ++j) {
      const std::uint32_t i = grown.tree.order()[j];
      const test::Quad dx = grown.units.position(grown.places.x[i]) - test::centre_x(at);
      const test::Quad dy = grown.units.position(grown.places.y[i]) - test::centre_y(at);
      worst = std::max(worst, std::max(test::magnitude(dx), test::magnitude(dy)) / at.side - 0.5);
    }
  }
  return worst;
}

std::uint32_t fullest(const fmm::DeepTree& tree) {
  std::uint32_t most = 0;
  for (const std::uint32_t c : tree.childless()) {
    most = std::max(most, tree.cells()[c].points.size());
  }
  return most;
}

void check_laws(const Grown& grown) {
  CHECK(families_add_up(grown.tree));
  CHECK(levels_add_up(grown.tree));
  CHECK(ranks_add_up(grown));
  CHECK(worst_centre(grown.tree) < 0x1p-98);
  CHECK(worst_place(grown) < 1e-6);
}

}  // namespace

TEST_CASE(
    "deep trees: families, levels and ranks add up, centres nest, points lie in their cells") {
  test::Uniform uniform(21);
  int deep = 0;
  for (int round = 0; round < 60; ++round) {
    const int kind = round % test::place_kinds;
    const auto n = 1 + uniform.below(round < 30 ? 60 : 3000);
    const auto capacity = static_cast<std::uint32_t>(1 + uniform.below(20));
    CAPTURE(round, n, capacity);
    const Grown grown(test::make_places(kind, n, uniform), capacity);
    check_laws(grown);
    deep += grown.tree.depth() > tree::max_level;
    if (kind < 5) CHECK(fullest(grown.tree) <= capacity);
  }
  CHECK(deep > 10);
}

TEST_CASE(
    "without clusters below its keys, or if told not to, a deep tree is the tree it grew from") {
  test::Uniform uniform(22);
  for (const bool deepen : {false, true}) {
    const Grown grown(test::make_places(deepen ? 0 : 3, 2000, uniform), 10, tree::max_level,
                      deepen);
    check_laws(grown);
    REQUIRE(grown.tree.cells().size() == grown.base.cells().size());
    for (std::size_t c = 0; c < grown.tree.cells().size(); ++c) {
      const fmm::DeepCell& deep = grown.tree.cells()[c];
      const tree::Cell& cell = grown.base.cells()[c];
      CHECK((deep.level == cell.level && deep.parent == cell.parent &&
             deep.children == cell.children && deep.points == cell.points));
    }
    CHECK(std::ranges::equal(grown.tree.childless(), grown.base.childless()));
  }
}

TEST_CASE("coincident points end the deepening at twice the levels of a key") {
  test::Places places;
  for (int i = 0; i < 3000; ++i) places.add(i % 3 * 0.3, 0.1);
  const Grown grown(places, 4);
  check_laws(grown);
  CHECK(grown.tree.depth() == 2 * tree::max_level);
  CHECK(fullest(grown.tree) == 1000);
  CHECK(grown.tree.cells().size() < 200);
}

TEST_CASE("clusters of the digits of a double are split to single points") {
  for (const double at : {0.0, 0.7}) {
    test::Places places;
    places.add(1.0, 1.0), places.add(0.0, 0.0);
    const double spacing = at == 0.0 ? 0x1p-56 : 0x1p-53;
    for (int i = 0; i < 900; ++i) places.add(at + i % 30 * spacing, at + i / 30 * spacing);
    const Grown grown(places, 1);
    check_laws(grown);
    CHECK(fullest(grown.tree) <= (at == 0.0 ? 2u : 1u));  // (0, 0) is there twice
    CHECK(grown.tree.depth() > 50);
  }
}

TEST_CASE("no points, no cells") {
  const Grown grown({}, 4);
  CHECK(grown.tree.cells().empty());
  CHECK(grown.tree.childless().empty());
}
