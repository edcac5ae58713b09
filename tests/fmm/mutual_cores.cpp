#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "fmm/mutual_core_kernel.hpp"
#include "point_sets.hpp"
#include "tree/memory.hpp"

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

/// The largest difference from pair by pair sums, over the largest sum, of all points.
template <class Weight, class Number>
double difference(std::size_t size, bool bare, fmm::Cores cores) {
  using Vector = typename fmm::VectorOf<Number>::Type;
  constexpr std::size_t n = fmm::VectorOf<Number>::count;
  const Meeting made(size, n, bare);
  std::vector<Number> x, y, gamma, core;
  for (std::size_t i = 0; i < size; ++i) {
    x.push_back(static_cast<Number>(made.x[i])), y.push_back(static_cast<Number>(made.y[i]));
    gamma.push_back(static_cast<Number>(made.gamma[i]));
    core.push_back(Weight::packed(static_cast<Number>(made.square[i])));
  }
  Unwritten<Vector> u(size, Vector{}), v(size, Vector{});
  fmm::OtherPoints<Vector> others{};
  for (std::size_t k = 0; k < n; ++k) {
    others.x[k] = static_cast<Number>(made.x[size + k]);
    others.y[k] = static_cast<Number>(made.y[size + k]);
    others.gamma[k] = static_cast<Number>(made.gamma[size + k]);
    others.core[k] = static_cast<Number>(made.square[size + k]);
  }
  others.core = Weight::packed(others.core);
  const fmm::CellPoints<Number> cell{x.data(), y.data(), gamma.data(), core.data(),
                                     u.data(), v.data(), size};
  fmm::meet_others<Weight, true>(cell, others);

  std::vector<double> sum_u(size + n), sum_v(size + n);
  const auto act = [&](std::size_t to, std::size_t from) {
    const double dx = made.x[to] - made.x[from], dy = made.y[to] - made.y[from];
    const double square = cores == fmm::Cores::source ? made.square[from]
                                                      : 0.5 * (made.square[from] + made.square[to]);
    const double w = fmm::pair_weight_plain(dx * dx + dy * dy, made.gamma[from], square);
    sum_u[to] -= w * dy, sum_v[to] += w * dx;
  };
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t k = 0; k < n; ++k) act(i, size + k), act(size + k, i);
  }
  double worst = 0, largest = 0;
  const auto compare = [&](double found_u, double found_v, std::size_t i) {
    worst = std::max({worst, std::abs(found_u - sum_u[i]), std::abs(found_v - sum_v[i])});
    largest = std::max({largest, std::abs(sum_u[i]), std::abs(sum_v[i])});
  };
  for (std::size_t i = 0; i < size; ++i) compare(sum(u[i]), sum(v[i]), i);
  for (std::size_t k = 0; k < n; ++k) {
    compare(static_cast<double>(others.u[k]), static_cast<double>(others.v[k]), size + k);
  }
  return worst / largest;
}

}  // namespace

TEST_CASE("mutual sums of cored vortices equal those pair by pair, both ways, in both precisions") {
  using fmm::Cores, fmm::CoarseExp, fmm::FineExp;
  for (const std::size_t size : {1u, 7u, 8u, 9u, 50u}) {
    CAPTURE(size);
    CHECK(difference<fmm::MutualBare, double>(size, true, Cores::source) < 1e-14);
    CHECK(difference<fmm::MutualMeanCore<FineExp>, double>(size, false, Cores::mean) < 1e-14);
    CHECK(difference<fmm::MutualMeanCore<FineExp>, double>(size, true, Cores::mean) < 1e-14);
    CHECK(difference<fmm::MutualSourceCore<FineExp>, double>(size, false, Cores::source) < 1e-14);
    CHECK(difference<fmm::MutualMeanCore<CoarseExp>, double>(size, false, Cores::mean) < 1e-7);
    CHECK(difference<fmm::MutualMeanCore<CoarseExp>, float>(size, false, Cores::mean) < 3e-6);
    CHECK(difference<fmm::MutualSourceCore<CoarseExp>, float>(size, false, Cores::source) < 3e-6);
  }
}
