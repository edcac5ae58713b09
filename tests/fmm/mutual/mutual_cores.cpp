#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <type_traits>
#include <vector>

#include "fmm/field/derivatives.hpp"
#include "fmm/mutual/mutual_core_kernel.hpp"
#include "point_sets.hpp"
#include "tree/base/memory.hpp"

using namespace vortree;

namespace {

/// Some points of a cell and one vector of others; every fifth of the cell is where another one is.
struct Meeting {
  std::vector<double> x, y, gamma, square;
  std::size_t size;

  Meeting(std::size_t cell, std::size_t others, bool bare) : size(cell) {
    test::Uniform uniform(cell + 1000 * others);
    for (std::size_t i = 0; i < cell + others; ++i) {
      x.push_back(4 * uniform()), y.push_back(4 * uniform()), gamma.push_back(2 * uniform() - 1);
      square.push_back(bare ? 0.0 : std::pow(10.0, 2 * uniform() - 1));
    }
    for (std::size_t i = 4; i < cell; i += 5) {
      x[i] = x[cell + i % others], y[i] = y[cell + i % others];
    }
  }
};

/// The weight of meet_bare.
struct Bare {
  template <class Value>
  static Value packed(Value) {
    return Value{};
  }
};

/// Sums of all points pair by pair, those of the cell first: u, v, du/dx, du/dy, dv/dx.
std::array<std::vector<double>, 5> pair_by_pair(const Meeting& made, fmm::Cores cores) {
  const std::size_t all = made.x.size();
  std::array<std::vector<double>, 5> sums;
  for (auto& sum : sums) sum.resize(all);
  const auto act = [&](std::size_t to, std::size_t from) {
    const double dx = made.x[to] - made.x[from], dy = made.y[to] - made.y[from];
    const double square = cores == fmm::Cores::source ? made.square[from]
                                                      : 0.5 * (made.square[from] + made.square[to]);
    const double w = fmm::pair_weight_plain(dx * dx + dy * dy, made.gamma[from], square);
    test::ExactFields slopes;
    if (square == 0.0)
      slopes.add_bare(made.gamma[from], dx, dy);
    else
      slopes.add_cored(made.gamma[from], dx, dy, square);
    sums[0][to] -= w * dy, sums[1][to] += w * dx;
    sums[2][to] += static_cast<double>(slopes.ux), sums[3][to] += static_cast<double>(slopes.uy);
    sums[4][to] += static_cast<double>(slopes.vx);
  };
  for (std::size_t i = 0; i < made.size; ++i) {
    for (std::size_t k = made.size; k < all; ++k) act(i, k), act(k, i);
  }
  return sums;
}

/// The largest differences from pair by pair sums, over the largest sum, of all points.
struct Differences {
  double velocity = 0, slopes = 0;
};

template <class Weight, class Number, std::size_t count = fmm::slope_sums>
Differences differences(std::size_t size, bool bare, fmm::Cores cores) {
  using Vector = typename fmm::VectorOf<Number>::Type;
  constexpr std::size_t n = fmm::VectorOf<Number>::count;
  const Meeting made(size, n, bare);
  std::vector<Number> x, y, gamma, core;
  for (std::size_t i = 0; i < size; ++i) {
    x.push_back(static_cast<Number>(made.x[i])), y.push_back(static_cast<Number>(made.y[i]));
    gamma.push_back(static_cast<Number>(made.gamma[i]));
    core.push_back(Weight::packed(static_cast<Number>(made.square[i])));
  }
  fmm::OtherPoints<Vector, count> others{};
  for (std::size_t k = 0; k < n; ++k) {
    others.x[k] = static_cast<Number>(made.x[size + k]);
    others.y[k] = static_cast<Number>(made.y[size + k]);
    others.gamma[k] = static_cast<Number>(made.gamma[size + k]);
    others.core[k] = static_cast<Number>(made.square[size + k]);
  }
  others.core = Weight::packed(others.core);
  std::array<Unwritten<Vector>, count> room;
  fmm::CellPoints<Number, count> cell{x.data(), y.data(), gamma.data(), core.data(), {}, size};
  for (std::size_t s = 0; s < count; ++s) {
    room[s].assign(size, Vector{});
    cell.sum[s] = room[s].data();
  }
  if constexpr (std::is_same_v<Weight, Bare>)
    fmm::meet_bare<true>(cell, others);
  else
    fmm::meet_cored<Weight, true>(cell, others);

  const auto exact = pair_by_pair(made, cores);
  const auto found = [&](std::size_t s, std::size_t i) {
    return i < size ? sum(room[s][i]) : static_cast<double>(others.sum[s][i - size]);
  };
  double worst[2] = {}, largest[2] = {};
  const auto compare = [&](int kind, double value, double expected) {
    worst[kind] = std::max(worst[kind], std::abs(value - expected));
    largest[kind] = std::max(largest[kind], std::abs(expected));
  };
  for (std::size_t i = 0; i < size + n; ++i) {
    compare(0, found(0, i), exact[0][i]);
    compare(0, found(1, i), exact[1][i]);
    if constexpr (count == fmm::slope_sums) {
      compare(1, found(3, i), exact[2][i]);
      compare(1, found(2, i) - found(4, i), exact[3][i]);
      compare(1, found(2, i) + found(4, i), exact[4][i]);
    }
  }
  return {worst[0] / largest[0], worst[1] / std::max(largest[1], 1e-300)};
}

template <class Weight, class Number>
void check_all(std::size_t size, bool bare, fmm::Cores cores, double most) {
  const Differences with_slopes = differences<Weight, Number>(size, bare, cores);
  CHECK(with_slopes.velocity < most);
  CHECK(with_slopes.slopes < most);
  CHECK(differences<Weight, Number, fmm::velocity_sums>(size, bare, cores).velocity < most);
}

}  // namespace

TEST_CASE("mutual sums of cored vortices equal those pair by pair, both ways, in both precisions") {
  using fmm::Cores, fmm::CoarseExp, fmm::FineExp;
  for (const std::size_t size : {1u, 7u, 8u, 9u, 50u}) {
    CAPTURE(size);
    check_all<Bare, double>(size, true, Cores::source, 1e-14);
    check_all<Bare, float>(size, true, Cores::source, 2e-5);
    check_all<fmm::MutualMeanCore<FineExp>, double>(size, false, Cores::mean, 1e-14);
    check_all<fmm::MutualMeanCore<FineExp>, double>(size, true, Cores::mean, 1e-14);
    check_all<fmm::MutualSourceCore<FineExp>, double>(size, false, Cores::source, 1e-14);
    check_all<fmm::MutualSourceCore<FineExp>, double>(size, true, Cores::source, 1e-14);
    check_all<fmm::MutualMeanCore<CoarseExp>, double>(size, false, Cores::mean, 1e-7);
    check_all<fmm::MutualMeanCore<CoarseExp>, float>(size, false, Cores::mean, 3e-6);
    check_all<fmm::MutualSourceCore<CoarseExp>, float>(size, false, Cores::source, 3e-6);
  }
}
