#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>

#include "tree/clouds.hpp"
#include "tree/neighbors/neighbors.hpp"
#include "tree/neighbors/verlet_list.hpp"
#include "tree/pairs.hpp"
#include "tree/reaches.hpp"

using namespace vortree;
using tree::Listing;
using tree::PairRule;

namespace {

// 53 bits as a double, and room for any exponent that squares may have.
using Wide = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<53, boost::multiprecision::digit_base_2, void, int, -9000,
                                         9000>,
    boost::multiprecision::et_off>;

struct Particles {
  test::Cloud cloud;
  std::vector<double> reach;

  [[nodiscard]] bool neighbors(PairRule rule, std::size_t i, std::size_t j) const {
    const double larger = rule == PairRule::own ? reach[i] : std::max(reach[i], reach[j]);
    // Doubles are as good where no square can overflow or underflow, and a hundred times as fast.
    if (larger > 1e-130 && larger < 1e150) {
      return test::is_neighbor(cloud.points(), reach, rule, i, j);
    }
    const Wide dx = cloud.x[j] - cloud.x[i], dy = cloud.y[j] - cloud.y[i];
    const Wide ri = reach[i], rj = reach[j];
    const Wide r = rule == PairRule::max    ? std::max(ri, rj)
                   : rule == PairRule::mean ? (ri + rj) / 2
                                            : ri;
    return dx * dx + dy * dy < r * r;
  }
  [[nodiscard]] test::Pairs pairs(PairRule rule) const {
    test::Pairs found;
    for (std::size_t i = 0; i < reach.size(); ++i) {
      for (std::size_t j = 0; j < reach.size(); ++j) {
        if (j != i && neighbors(rule, i, j)) found.emplace_back(i, j);
      }
    }
    return found;
  }
};

std::size_t check(const Particles& p) {
  std::size_t count = 0;
  tree::Neighbors search;
  search.place(p.cloud.points(), p.reach);
  for (const PairRule rule : {PairRule::max, PairRule::mean, PairRule::own}) {
    const test::Pairs truth = p.pairs(rule);
    count += truth.size();
    tree::PairList rows;
    for (const Listing listing : {Listing::both_ways, Listing::once}) {
      if (rule == PairRule::own && listing == Listing::once) continue;
      CAPTURE(static_cast<int>(rule), static_cast<int>(listing));
      search.list(rule, listing, rows);
      REQUIRE((test::pairs_of(rows, listing) == truth));
    }
    tree::VerletList list(rule, Listing::both_ways, rule == PairRule::max ? 0.2 : 1e-12);
    list.rebuild(p.cloud.points(), p.reach);
    list.narrow(p.cloud.points(), p.reach, rows);
    REQUIRE((test::pairs_of(rows, Listing::both_ways) == truth));
    REQUIRE_FALSE(list.outdated(p.cloud.points(), p.reach));
  }
  return count;
}

// Places in units of their spacing.
using Pattern = std::function<std::pair<double, double>(int)>;

std::vector<Pattern> patterns(int n, test::Chance& chance) {
  const int side = static_cast<int>(std::sqrt(n));
  return {[](int i) { return std::pair<double, double>(i, i); },
          [](int i) { return std::pair<double, double>(i, -i); },
          [side](int i) { return std::pair<double, double>(i % side, i / side); },
          [side](int i) { return std::pair<double, double>(i % side, 1e-3 * (i / side)); },
          [side](int i) {
            const double a = i % side, b = i / side;
            return std::pair(0.8 * a - 0.6 * b, 0.6 * a + 0.8 * b);
          },
          [n, &chance](int) { return std::pair(n * chance.real(), n * chance.real()); },
          [side, &chance](int i) {
            return std::pair(side * chance.real() + 1e3 * (i % 3),
                             side * chance.real() - 1e6 * (i % 3));
          }};
}

}  // namespace

TEST_CASE("lists are exact down to the spacing of doubles, wherever a lattice or dust lies") {
  test::Chance chance(91);
  constexpr int n = 100;
  const std::pair<double, double> places[] = {{1, 1}, {-1, -1e-4}, {1.3, -1e7}, {-3e5, 0}};
  std::size_t pairs = 0;
  for (const Pattern& at : patterns(n, chance)) {
    for (const auto& [x, y] : places) {
      for (int e = -54; e <= -27; e += chance.whole(3, 6)) {
        const double spacing = std::ldexp(std::max(std::abs(x), std::abs(y)), e);
        const int kind = chance.whole(0, 2);
        const double same = chance.whole(1, 5) * (kind == 0 ? 1 : std::sqrt(2.0));
        Particles p;
        for (int i = 0; i < n; ++i) {
          const auto [a, b] = at(i);
          p.cloud.add(x + spacing * a, y + spacing * b);
          p.reach.push_back(spacing * (kind < 2 ? same : std::ldexp(8, -chance.whole(0, 5))));
        }
        CAPTURE(x, y, e, kind);
        pairs += check(p);
      }
    }
  }
  CHECK(pairs > 50000);
}

TEST_CASE("lists are those of exponents without bounds, from subnormal lengths to the largest") {
  test::Chance chance(92);
  for (int e = -1074; e <= 1010; e += chance.whole(60, 140)) {
    for (const int spread : {0, 9, 300}) {
      Particles p;
      const auto length = [&] { return std::ldexp(chance.real(), e - chance.whole(0, spread)); };
      for (int i = 0; i < 40; ++i) {
        p.cloud.add(9 * length() - 4 * length(), 4 * length() - 9 * length());
        p.reach.push_back(chance.whole(0, 9) == 0 ? 0 : 3 * length());
      }
      CAPTURE(e, spread);
      check(p);
    }
  }
}

TEST_CASE("reaches may be the least or the largest double, beside any spacing") {
  test::Chance chance(93);
  const double least = std::numeric_limits<double>::denorm_min();
  const double most = std::numeric_limits<double>::max();
  for (int kind = 0; kind < test::cloud_kinds; ++kind) {
    Particles p{test::make_cloud(kind, 40, chance), {}};
    p.reach.assign(40, least);
    CAPTURE(kind);
    check(p);
    for (double& r : p.reach) r = std::ldexp(1.0, chance.whole(-1074, 1023));
    check(p);
    for (double& r : p.reach) r = chance.whole(0, 1) == 0 ? most : least;
    check(p);
  }
}

TEST_CASE("a particle that moved too far is noticed, where squares of its way underflow too") {
  for (const double scale : {1e-300, 1.0, 1e200}) {
    std::vector<double> x{0, scale}, y{0, 0};
    const std::vector<double> reach{2 * scale, 2 * scale};
    tree::VerletList list(PairRule::max, Listing::both_ways, 0.1);
    list.rebuild({x, y}, reach);
    x[1] = 1.0999 * scale;
    CHECK_FALSE(list.outdated({x, y}, reach));
    x[1] = 1.1001 * scale;
    CHECK(list.outdated({x, y}, reach));
  }
}
