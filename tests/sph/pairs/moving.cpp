#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "sph/pairs/resolution.hpp"
#include "tree/clouds.hpp"
#include "tree/neighbors/verlet_list.hpp"
#include "tree/pairs.hpp"

using namespace vortree;
using tree::Listing;
using tree::PairRule;

namespace {

sph::Particles lattice(int side, test::Chance& chance) {
  sph::Particles made;
  const double dx = 1.0 / side;
  for (int i = 0; i < side * side; ++i) {
    made.add((i % side + 0.5 + 0.1 * chance.real()) * dx,
             (i / side + 0.5 + 0.1 * chance.real()) * dx, dx * dx, 3.9 * dx);
  }
  return made;
}

// A vortex in the unit square and a little noise, so that no two steps are the same.
void move(sph::Particles& p, double dt, test::Chance& chance) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double x = p.x[i] - 0.5, y = p.y[i] - 0.5, turn = std::exp(-8 * (x * x + y * y));
    p.x[i] += dt * (-turn * y + 0.02 * (chance.real() - 0.5));
    p.y[i] += dt * (turn * x + 0.02 * (chance.real() - 0.5));
  }
}

// Finer inside a disc that wanders about, coarser where it has been.
struct Refinement {
  double x, y;
  [[nodiscard]] int level(const sph::Particles& p, std::size_t i) const {
    const double r = std::hypot(p.x[i] - x, p.y[i] - y);
    return r < 0.06 ? 3 : r < 0.12 ? 2 : r < 0.2 ? 1 : 0;
  }
  void apply(sph::Particles& p) const {
    sph::split(p, [&](std::size_t i) { return p.level(i) < level(p, i); });
    sph::merge(p, [&](std::size_t i) { return p.level(i) > level(p, i); });
  }
};

double total(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

}  // namespace

TEST_CASE(
    "over a thousand steps of moving, splitting and merging, lists equal those of all pairs") {
  test::Chance chance(71);
  sph::Particles p = lattice(16, chance);
  tree::Neighbors search;
  tree::VerletList skinned(PairRule::max, Listing::both_ways, 0.15);
  tree::PairList rows;
  int rebuilt = 0, checked = 0;
  std::size_t fewest = p.size(), most = p.size();
  for (int step = 0; step < 1000; ++step) {
    move(p, 0.004, chance);
    const double turn = 0.01 * step;
    if (step % 10 == 0)
      Refinement{0.5 + 0.25 * std::cos(turn), 0.5 + 0.25 * std::sin(turn)}.apply(p);
    fewest = std::min(fewest, p.size()), most = std::max(most, p.size());
    search.place(p.points(), p.reach);
    if (skinned.outdated(p.points(), p.reach)) skinned.rebuild(p.points(), p.reach), ++rebuilt;
    if (chance.whole(0, 19) != 0) continue;
    ++checked;
    CAPTURE(step, p.size());
    const test::Pairs truth = test::all_pairs(p.points(), p.reach, PairRule::max);
    for (const Listing listing : {Listing::both_ways, Listing::once}) {
      search.list(PairRule::max, listing, rows);
      REQUIRE((test::pairs_of(rows, listing) == truth));
    }
    skinned.narrow(p.points(), p.reach, rows);
    REQUIRE((test::pairs_of(rows, Listing::both_ways) == truth));
  }
  CHECK(checked > 20);
  CHECK(rebuilt < 500);  // the skin saves something
  CHECK(most > fewest + 200);
}

TEST_CASE("a list with a skin says when it must be built anew") {
  test::Chance chance(72);
  sph::Particles p = lattice(10, chance);
  tree::VerletList list(PairRule::max, Listing::both_ways, 0.1);
  const auto outdated = [&] { return list.outdated(p.points(), p.reach); };
  CHECK(outdated());
  list.rebuild(p.points(), p.reach);
  CHECK_FALSE(outdated());
  const double x = p.x[7], reach = p.reach[7];
  p.x[7] = x + 0.0499 * reach;
  CHECK_FALSE(outdated());
  p.x[7] = x - 0.0501 * reach;
  CHECK(outdated());
  p.x[7] = std::nan("");
  CHECK(outdated());
  p.x[7] = x;
  p.reach[7] = 1.01 * reach;
  CHECK(outdated());
  p.reach[7] = 0.5 * reach;
  CHECK_FALSE(outdated());
  sph::split(p, [](std::size_t i) { return i == 3; });
  CHECK(outdated());
  CHECK_THROWS_WITH(tree::VerletList(PairRule::max, Listing::once, -0.1),
                    Catch::Matchers::Contains("skin is -0.1"));
}

TEST_CASE("until then it holds every neighbor, by every rule, however the particles move") {
  test::Chance chance(73);
  for (const PairRule rule : {PairRule::max, PairRule::mean, PairRule::own}) {
    for (int round = 0; round < 20; ++round) {
      sph::Particles p = lattice(12, chance);
      sph::split(p, [&](std::size_t) { return chance.whole(0, 3) == 0; });
      tree::VerletList list(rule, Listing::both_ways, 0.3);
      list.rebuild(p.points(), p.reach);
      const double least = *std::min_element(p.reach.begin(), p.reach.end());
      for (std::size_t i = 0; i < p.size(); ++i) {
        const double turn = 6.28 * chance.real();
        const double far = 0.1499 * (rule == PairRule::own ? least : p.reach[i]);
        p.x[i] += far * std::cos(turn), p.y[i] += far * std::sin(turn);
      }
      REQUIRE_FALSE(list.outdated(p.points(), p.reach));
      tree::PairList rows;
      list.narrow(p.points(), p.reach, rows);
      REQUIRE(
          (test::pairs_of(rows, Listing::both_ways) == test::all_pairs(p.points(), p.reach, rule)));
    }
  }
}

TEST_CASE("splitting conserves mass and its centre; merging undoes it") {
  test::Chance chance(74);
  sph::Particles p = lattice(9, chance);
  const sph::Particles before = p;
  const auto all = [](std::size_t) { return true; };
  sph::split(p, [](std::size_t i) { return i % 3 == 0; });
  CHECK(p.size() == 81 + 3 * 27);
  sph::split(p, all);
  CHECK(p.size() == 4 * (81 + 3 * 27));
  CHECK(total(p.mass) == Approx(total(before.mass)));
  const auto moment = [](const sph::Particles& q) {
    return std::inner_product(q.mass.begin(), q.mass.end(), q.x.begin(), 0.0);
  };
  CHECK(moment(p) == Approx(moment(before)));
  sph::merge(p, all);
  CHECK(p.size() == 81 + 3 * 27);
  sph::merge(p, all);
  REQUIRE(p.size() == 81);
  for (std::size_t i = 0; i < 81; ++i) {
    const std::size_t k = p.root[i];
    CHECK(p.path[i] == 1);
    CHECK(p.x[i] == Approx(before.x[k]));
    CHECK(p.y[i] == Approx(before.y[k]));
    CHECK(p.reach[i] == before.reach[k]);
    CHECK(p.mass[i] == Approx(before.mass[k]));
  }
}

TEST_CASE("three of four parts do not merge") {
  sph::Particles p;
  p.add(0, 0, 1, 1);
  sph::split(p, [](std::size_t) { return true; });
  sph::merge(p, [](std::size_t i) { return i != 2; });
  CHECK(p.size() == 4);
}
