#include "sph/neighbors/kept_list.hpp"

#include <omp.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "neighbors/sort_rows.hpp"
#include "tree/clouds.hpp"
#include "tree/neighbors/neighbors.hpp"

using namespace vortree;
using namespace vortree::sph;
using vortree::test::Chance;

namespace {

/// Particles of three sizes that do what those of a flow do.
struct Swarm {
  std::vector<double> x, y, reach;
  std::vector<std::int32_t> was;

  [[nodiscard]] tree::Points points() const { return {x, y}; }
  [[nodiscard]] std::size_t size() const { return x.size(); }

  void add(double at_x, double at_y, double r) {
    x.push_back(at_x), y.push_back(at_y), reach.push_back(r), was.push_back(-1);
  }
  void remove(std::size_t k) {
    const auto at = static_cast<std::ptrdiff_t>(k);
    for (auto* values : {&x, &y, &reach}) values->erase(values->begin() + at);
    was.erase(was.begin() + at);
  }
  void exchange(std::size_t i, std::size_t j) {
    for (auto* values : {&x, &y, &reach}) std::swap((*values)[i], (*values)[j]);
    std::swap(was[i], was[j]);
  }
  void number() { std::iota(was.begin(), was.end(), 0); }
};

double any(Chance& chance) {
  return 2 * chance.real() - 1;
}

void put_anywhere(Swarm& swarm, double extent, Chance& chance) {
  swarm.add(extent * any(chance), extent * any(chance),
            0.1 * extent * std::ldexp(1 + 0.2 * any(chance), -chance.whole(0, 2)));
}

Swarm make_swarm(int n, double extent, Chance& chance) {
  Swarm swarm;
  for (int k = 0; k < n; ++k) put_anywhere(swarm, extent, chance);
  return swarm;
}

/// How far all move in a step, how many come and go, and how often all numbers change.
struct Habits {
  double move, change;  // in reaches
  int come, go, shuffle_every;
};

void live(Swarm& swarm, const Habits& habits, double extent, int step, Chance& chance) {
  for (std::size_t k = 0; k < swarm.size(); ++k) {
    swarm.x[k] += habits.move * swarm.reach[k] * any(chance);
    swarm.y[k] += habits.move * swarm.reach[k] * any(chance);
    swarm.reach[k] *= 1 + habits.change * any(chance);
  }
  for (int k = 0; k < habits.go; ++k)
    swarm.remove(static_cast<std::size_t>(chance.whole(0, static_cast<int>(swarm.size()) - 1)));
  for (int k = 0; k < habits.come; ++k) put_anywhere(swarm, extent, chance);
  if (habits.shuffle_every > 0 && step % habits.shuffle_every == 0)
    for (std::size_t k = swarm.size(); k > 1; --k)
      swarm.exchange(k - 1, static_cast<std::size_t>(chance.whole(0, static_cast<int>(k) - 1)));
}

void search(tree::Points points, std::span<const double> reach, tree::PairList& rows) {
  rows = tree::neighbors(points, reach, tree::PairRule::mean);
  neighbors::sort_rows(rows);
}

bool same(const tree::PairList& a, const tree::PairList& b) {
  return std::ranges::equal(a.start.span(), b.start.span()) &&
         std::ranges::equal(a.index.span(), b.index.span());
}

/// Held against a search from scratch in every step.
KeptList lives_on(const Habits& habits, double skin, int steps, double extent, std::uint64_t seed) {
  Chance chance(seed);
  Swarm swarm = make_swarm(400, extent, chance);
  KeptList kept;
  tree::PairList rows, fresh;
  for (int step = 0; step < steps; ++step) {
    kept.renew(swarm.points(), swarm.reach, swarm.was, skin, search, rows);
    swarm.number();
    search(swarm.points(), swarm.reach, fresh);
    CAPTURE(step);
    REQUIRE(same(rows, fresh));
    live(swarm, habits, extent, step, chance);
  }
  return kept;
}

}  // namespace

TEST_CASE("a kept list holds the neighbors of a search from scratch, whatever particles do") {
  const int steps = 60;
  for (const double skin : {0.01, 0.1, 0.4, 1.5}) {
    CAPTURE(skin);
    for (const Habits& habits : {Habits{0.004, 0, 0, 0, 0},
                                 {0.004, 0.002, 0, 0, 0},
                                 {0, 0, 5, 5, 0},
                                 {0, 0, 3, 7, 4},
                                 {0.01, 0.005, 5, 3, 5},
                                 {0.01, 0.01, 0, 0, 1},
                                 {0.3, 0.1, 20, 20, 1}})
      lives_on(habits, skin, steps, 1, 17);
  }
}

TEST_CASE("lists are kept where little moves, and made anew where much does") {
  const KeptList still = lives_on({0, 0, 0, 0, 0}, 0.1, 20, 1, 3);
  CHECK(still.rebuilt() == 1);
  CHECK(still.sought() == 0);
  const KeptList births = lives_on({0, 0, 5, 5, 3}, 0.1, 20, 1, 3);
  CHECK(births.rebuilt() == 1);
  CHECK(births.sought() == 5 * 19);
  const KeptList fast = lives_on({1, 0, 0, 0, 0}, 0.1, 20, 1, 3);
  CHECK(fast.rebuilt() == 20);
  const KeptList wider = lives_on({0.02, 0, 0, 0, 0}, 0.8, 20, 1, 3);
  const KeptList narrow = lives_on({0.02, 0, 0, 0, 0}, 0.1, 20, 1, 3);
  CHECK(wider.rebuilt() == 1);
  CHECK(wider.sought() < narrow.sought());
}

TEST_CASE("a kept list is exact for lengths of any size") {
  for (const double extent : {1e-200, 1e-30, 1e30, 1e200}) {
    CAPTURE(extent);
    const KeptList kept = lives_on({0.01, 0.005, 4, 3, 5}, 0.3, 20, extent, 5);
    CHECK(kept.rebuilt() < 20);
  }
}

TEST_CASE("numbers that are wrong cost no neighbor") {
  Chance chance(8);
  Swarm swarm = make_swarm(300, 1, chance);
  KeptList kept;
  tree::PairList rows, fresh;
  for (int step = 0; step < 40; ++step) {
    for (std::int32_t& was : swarm.was) was = step % 2 ? chance.whole(-1, 400) : chance.whole(0, 5);
    kept.renew(swarm.points(), swarm.reach, swarm.was, 0.5, search, rows);
    search(swarm.points(), swarm.reach, fresh);
    REQUIRE(same(rows, fresh));
    live(swarm, {0.05, 0.01, 2, 3, 0}, 1, step, chance);
  }
}

TEST_CASE("a kept list is the same for any number of threads") {
  const int before = omp_get_max_threads();
  for (const int threads : {1, 2, 5}) {
    omp_set_num_threads(threads);
    lives_on({0.01, 0.005, 5, 3, 5}, 0.3, 20, 1, 9);
  }
  omp_set_num_threads(before);
}

TEST_CASE("a kept list of none and of one") {
  Swarm swarm;
  KeptList kept;
  tree::PairList rows;
  kept.renew(swarm.points(), swarm.reach, swarm.was, 0.5, search, rows);
  CHECK(rows.size() == 0);
  swarm.add(0, 0, 1);
  kept.renew(swarm.points(), swarm.reach, swarm.was, 0.5, search, rows);
  CHECK(rows.size() == 1);
  CHECK(rows.row(0).empty());
  swarm.number();
  swarm.add(0.5, 0, 1);
  kept.renew(swarm.points(), swarm.reach, swarm.was, 0.5, search, rows);
  REQUIRE(rows.row(0).size() == 1);
  CHECK(rows.row(1)[0] == 0);
}
