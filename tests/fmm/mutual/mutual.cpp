#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "fmm/mutual/mutual_kernel.hpp"
#include "point_sets.hpp"

using namespace vortree;

namespace {

/// Cells of points side by side in whole vectors, as Leaves holds them, and their sums.
struct Cells {
  std::vector<double> x, y, gamma, u, v;
  std::vector<std::size_t> first, size;  // of the true points

  void add(std::size_t count, test::Uniform& uniform) {
    first.push_back(x.size()), size.push_back(count);
    for (std::size_t i = 0; i < count; ++i) {
      // Every fifth point is where an earlier one is, in this cell or in another.
      const bool again = i % 5 == 4;
      const std::size_t other = again ? uniform.below(x.size()) : 0;
      const double here_x = uniform(), here_y = uniform();
      x.push_back(again ? double{x[other]} : here_x);
      y.push_back(again ? double{y[other]} : here_y);
      gamma.push_back(2 * uniform() - 1);
    }
    while (x.size() % lane_count != 0) {
      x.push_back(double{x.back()}), y.push_back(double{y.back()}), gamma.push_back(0.0);
    }
    u.assign(x.size(), 0.0), v.assign(x.size(), 0.0);
  }

  [[nodiscard]] fmm::MutualPoints points() {
    return {x.data(), y.data(), gamma.data(), u.data(), v.data()};
  }
  /// The places of the vectors of a cell.
  [[nodiscard]] std::vector<std::uint32_t> blocks(std::size_t cell) const {
    std::vector<std::uint32_t> places;
    for (std::size_t j = 0; j < size[cell]; j += lane_count) {
      places.push_back(static_cast<std::uint32_t>(first[cell] + j));
    }
    return places;
  }

  /// Adds what the points of a cell do to those of another, pair by pair.
  void add_plain(std::size_t to, std::size_t from, std::vector<long double>& plain_u,
                 std::vector<long double>& plain_v) const {
    for (std::size_t i = first[to]; i < first[to] + size[to]; ++i) {
      for (std::size_t j = first[from]; j < first[from] + size[from]; ++j) {
        const long double dx = static_cast<long double>(x[i]) - x[j];
        const long double dy = static_cast<long double>(y[i]) - y[j];
        const long double w =
            fmm::pair_weight_plain<long double>(dx * dx + dy * dy, gamma[j], 0.0L);
        plain_u[i] -= w * dy, plain_v[i] += w * dx;
      }
    }
  }

  /// Largest difference from the plain sums in a cell, over the largest sum there.
  [[nodiscard]] double difference(std::size_t cell, const std::vector<long double>& plain_u,
                                  const std::vector<long double>& plain_v) const {
    long double worst = 0, largest = 0;
    for (std::size_t i = first[cell]; i < first[cell] + size[cell]; ++i) {
      worst = std::max({worst, std::abs(u[i] - plain_u[i]), std::abs(v[i] - plain_v[i])});
      largest = std::max({largest, std::abs(plain_u[i]), std::abs(plain_v[i])});
    }
    return static_cast<double>(largest == 0 ? worst : worst / largest);
  }
};

/// Cell 0 meets itself and all the others at once; returns the sums of all.
template <bool both>
Cells meet(Cells cells) {
  std::vector<Lanes> room_u(padded(cells.size[0])), room_v(room_u.size());
  const fmm::MutualCell cell{cells.first[0], room_u.size(), room_u.data(), room_v.data()};
  std::vector<std::uint32_t> blocks;
  for (std::size_t c = 1; c < cells.size.size(); ++c) {
    for (const std::uint32_t j : cells.blocks(c)) blocks.push_back(j);
  }
  fmm::meet_itself(cells.points(), cell);
  fmm::meet_all<both>(cells.points(), cell, blocks);
  fmm::close(cells.points(), cell);
  return cells;
}

Cells make_cells(std::size_t own, std::initializer_list<std::size_t> others) {
  test::Uniform uniform(own + 100 * others.size());
  Cells cells;
  cells.add(own, uniform);
  for (const std::size_t size : others) cells.add(size, uniform);
  return cells;
}

}  // namespace

TEST_CASE("mutual near sums equal those pair by pair, coincident points among them") {
  for (const std::size_t own : {1u, 7u, 8u, 30u}) {
    // One to eight blocks and more: every way to take them by threes and twos.
    for (const auto& others : {std::initializer_list<std::size_t>{},
                               {5},
                               {9},
                               {8, 9},
                               {32},
                               {40},
                               {41},
                               {3, 1, 24, 9},
                               {64},
                               {1, 2, 3, 4, 5, 6, 7, 8, 9, 10}}) {
      CAPTURE(own, others.size());
      const Cells before = make_cells(own, others), after = meet<true>(before);
      std::vector<long double> u(before.x.size()), v(before.x.size());
      before.add_plain(0, 0, u, v);
      for (std::size_t c = 1; c < before.size.size(); ++c) {
        before.add_plain(0, c, u, v);
        before.add_plain(c, 0, u, v);
      }
      for (std::size_t c = 0; c < before.size.size(); ++c) CHECK(after.difference(c, u, v) < 1e-14);
    }
  }
}

TEST_CASE("one-sided near sums give the cell the same, and leave the others alone") {
  const Cells before = make_cells(21, {13, 8, 40, 1});
  const Cells mutual = meet<true>(before), single = meet<false>(before);
  std::vector<long double> u(mutual.u.begin(), mutual.u.end());
  std::vector<long double> v(mutual.v.begin(), mutual.v.end());
  CHECK(single.difference(0, u, v) < 1e-15);
  for (std::size_t i = single.first[1]; i < single.x.size(); ++i) {
    CHECK(single.u[i] == 0.0);
    CHECK(single.v[i] == 0.0);
    CHECK((mutual.u[i] != 0.0 || mutual.gamma[i] == 0.0));
  }
}

TEST_CASE("mutual near sums conserve sum gamma x") {
  const Cells cells = meet<true>(make_cells(30, {30, 17}));
  long double x = 0, y = 0, whole = 0;
  for (std::size_t i = 0; i < cells.x.size(); ++i) {
    x += cells.gamma[i] * cells.u[i], y += cells.gamma[i] * cells.v[i];
    whole += std::abs(cells.gamma[i] * cells.u[i]);
  }
  CHECK(std::abs(x) < 1e-14 * whole);
  CHECK(std::abs(y) < 1e-14 * whole);
}
