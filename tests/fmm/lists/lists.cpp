#include "fmm/lists/lists.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "fmm/grown.hpp"
#include "fmm/series/translation_kernel.hpp"

using namespace vortree;
using test::Grown;

namespace {

/// How often each list met, over many trees.
struct Seen {
  std::size_t v = 0, x = 0, near = 0, finer = 0, met = 0, refused = 0, itself = 0, deep_v = 0,
              deep_x = 0;
};

/// A kernel of one: of each childless cell, how often it counts every other.
class Count {
 public:
  Count(const Grown& grown, std::uint32_t few, const fmm::InteractionLists::Hidden& hidden)
      : tree_(grown.tree),
        hidden_(hidden),
        few_(few),
        lists_(grown.tree, few, hidden),
        local_(tree_.cells().size(), Row(tree_.childless().size())),
        at_(tree_.childless().size(), Row(tree_.childless().size())) {
    for (std::uint32_t c = 0; c < tree_.cells().size(); ++c) add_far(c);
    for (std::uint32_t leaf = 0; leaf < at_.size(); ++leaf) add_near(leaf);
    add_refused();
    for (std::uint32_t leaf = 0; leaf < at_.size(); ++leaf) {
      const Row& local = local_[tree_.childless()[leaf]];
      for (std::size_t k = 0; k < local.size(); ++k) at_[leaf][k] += local[k];
      for (const std::uint32_t c : lists_.w(leaf)) add(c, at_[leaf]);
    }
  }

  [[nodiscard]] bool once() const {
    return std::ranges::all_of(at_, [](const Row& row) {
      return std::ranges::all_of(row, [](int times) { return times == 1; });
    });
  }

  Seen seen;
  bool apart = true;      // V, X and W keep their distances
  bool both_ways = true;  // W is X, behind is ahead, refusals are mutual
  bool obedient = true;   // no series where they are refused

 private:
  using Row = std::vector<int>;

  void add(std::uint32_t cell, Row& row) const {
    const tree::Range leaves = lists_.leaves(cell);
    for (std::uint32_t k = leaves.first; k < leaves.last; ++k) ++row[k];
  }

  [[nodiscard]] bool serves(std::uint32_t a, std::uint32_t b, double gap) const {
    return !hidden_ || hidden_(a, b, gap);
  }

  /// The centres' differences over the side of a, and the gap of the squares over it.
  [[nodiscard]] std::array<double, 3> between(std::uint32_t a, std::uint32_t b) const {
    const fmm::CellFrame &own = tree_.frame(a), &other = tree_.frame(b);
    const auto dx = static_cast<double>((test::centre_x(own) - test::centre_x(other)) / own.side);
    const auto dy = static_cast<double>((test::centre_y(own) - test::centre_y(other)) / own.side);
    const double half = (1 + other.side / own.side) / 2;
    return {dx, dy, std::max(std::abs(dx), std::abs(dy)) - half};
  }

  /// L2L, M2L and P2L, as FarField does them.
  void add_far(std::uint32_t c) {
    if (c == 0) return;
    const auto parent = static_cast<std::uint32_t>(tree_.cells()[c].parent);
    local_[c] = local_[parent];
    for (int o = 0; o < fmm::orbit_count; ++o) {
      fmm::Offset d = fmm::orbits[o];
      for (int m = 0; m < 4; ++m, d = {-d.y, d.x}) {
        const int place = fmm::orbit_places[tree_.cells()[c].quadrant][o][m];
        if (place < 0 || !lists_.open(parent, place / 4)) continue;
        const auto family = static_cast<std::uint32_t>(lists_.neighbors(parent)[place / 4]);
        const std::int32_t source = lists_.children(family)[place % 4];
        if (source != fmm::nobody) meet_v(c, static_cast<std::uint32_t>(source), d);
        obedient = obedient && serves(parent, family, tree_.frame(c).side);
      }
    }
    for (const std::uint32_t b : lists_.x(c)) meet_x(c, b);
  }

  void meet_v(std::uint32_t c, std::uint32_t source, fmm::Offset d) {
    add(source, local_[c]);
    const auto [x, y, gap] = between(c, source);
    apart = apart && std::abs(x - d.x) < 1e-9 && std::abs(y - d.y) < 1e-9 && gap > 1 - 1e-9 &&
            gap < 2 + 1e-9 &&
            std::ranges::find(lists_.neighbors(c), static_cast<int>(source)) ==
                lists_.neighbors(c).end();
    ++seen.v, seen.deep_v += tree_.cells()[c].level > tree::max_level;
  }

  void meet_x(std::uint32_t c, std::uint32_t b) {
    add(b, local_[c]);
    const auto parent = static_cast<std::uint32_t>(tree_.cells()[c].parent);
    apart = apart && tree_.cells()[b].childless() &&
            tree_.cells()[b].level < tree_.cells()[c].level && between(c, b)[2] > 1 - 1e-9 &&
            std::abs(between(parent, b)[2]) < 1e-9;
    both_ways = both_ways && std::ranges::count(lists_.w(lists_.leaves(b).first), c) == 1;
    obedient = obedient && serves(c, b, tree_.frame(c).side);
    ++seen.x, seen.deep_x += tree_.cells()[c].level > tree::max_level;
  }

  void add_near(std::uint32_t leaf) {
    const std::uint32_t b = tree_.childless()[leaf];
    if (lists_.neighbors(b)[fmm::InteractionLists::middle] != fmm::nobody) {
      ++at_[leaf][leaf];
    } else {
      ++seen.itself;
    }
    lists_.for_each_ahead(b, [&](std::uint32_t a) {
      const std::uint32_t other = lists_.leaves(a).first;
      ++at_[leaf][other], ++at_[other][leaf];
      ahead_.insert({b, a});
      const double gap = between(b, a)[2];
      const bool sparse = gap > 1e-9;
      if (sparse) apart = apart && tree_.cells()[b].points.size() < few_;
      ++seen.near, seen.met += sparse,
          seen.finer += tree_.cells()[a].level < tree_.cells()[b].level;
    });
    lists_.for_each_behind(b, [&](std::uint32_t a) { behind_.insert({a, b}); });
    if (leaf + 1 == at_.size()) both_ways = both_ways && ahead_ == behind_;
  }

  void add_refused() {
    for (std::uint32_t c = 0; c < tree_.cells().size(); ++c) {
      const tree::Range leaves = lists_.leaves(c);
      for (const std::uint32_t q : lists_.refused(c)) {
        for (std::uint32_t k = leaves.first; k < leaves.last; ++k) add(q, at_[k]);
        both_ways = both_ways && std::ranges::count(lists_.refused(q), c) == 1;
        ++seen.refused;
      }
    }
  }

  const fmm::DeepTree& tree_;
  const fmm::InteractionLists::Hidden& hidden_;
  std::uint32_t few_;
  fmm::InteractionLists lists_;
  std::vector<Row> local_, at_;
  std::multiset<std::pair<std::uint32_t, std::uint32_t>> ahead_, behind_;
};

/// Refuses one pair in `one_of`, at random but the same for (a, b) and (b, a).
fmm::InteractionLists::Hidden refuse_some(std::uint32_t one_of) {
  return [one_of](std::uint32_t a, std::uint32_t b, double) {
    const std::uint64_t low = std::min(a, b), high = std::max(a, b);
    return (((low << 32 | high) + 7) * 0x9e3779b97f4a7c15u >> 40) % one_of != 0;
  };
}

void count_all(Seen& all, const Seen& seen) {
  all.v += seen.v, all.x += seen.x, all.near += seen.near, all.finer += seen.finer;
  all.met += seen.met, all.refused += seen.refused, all.itself += seen.itself;
  all.deep_v += seen.deep_v, all.deep_x += seen.deep_x;
}

Seen check_rounds(int rounds, const std::vector<fmm::InteractionLists::Hidden>& rules) {
  test::Uniform uniform(31);
  Seen all;
  for (int round = 0; round < rounds; ++round) {
    const auto n = 1 + uniform.below(round % 4 == 0 ? 30 : 500);
    const auto capacity = static_cast<std::uint32_t>(round % 5 == 0 ? 1 : 1 + uniform.below(12));
    const auto few = static_cast<std::uint32_t>(round % 3 == 0 ? 0 : uniform.below(8));
    const int finest = round % 7 == 0 ? 3 : tree::max_level;
    CAPTURE(round, n, capacity, few, finest);
    const Grown grown(test::make_places(round % test::place_kinds, n, uniform), capacity, finest,
                      finest == tree::max_level);
    const Count count(grown, few, rules[static_cast<std::size_t>(round) % rules.size()]);
    CHECK(count.once());
    CHECK(count.apart);
    CHECK(count.both_ways);
    CHECK(count.obedient);
    count_all(all, count.seen);
  }
  return all;
}

}  // namespace

TEST_CASE("with a kernel of one, U, V, W and X count every source once, at every target") {
  const Seen seen = check_rounds(120, {{}});
  CHECK(seen.v > 10000);
  CHECK(seen.x > 1000);
  CHECK(seen.near > 10000);
  CHECK(seen.finer > 1000);
  CHECK(seen.met > 1000);
  CHECK(seen.deep_v > 100);
  CHECK(seen.deep_x > 100);
  CHECK(seen.refused == 0);
  CHECK(seen.itself == 0);
}

TEST_CASE("where pairs of cells refuse series, their points still count each other once") {
  const Seen seen =
      check_rounds(240, {refuse_some(3), refuse_some(10), refuse_some(100), refuse_some(1)});
  CHECK(seen.v > 10000);
  CHECK(seen.x > 1000);
  CHECK(seen.met > 1000);
  CHECK(seen.refused > 1000);
  CHECK(seen.itself > 100);
}
