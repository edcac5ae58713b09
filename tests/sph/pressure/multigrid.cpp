// GCC 12 takes the undefined lanes of its own AVX-512 intrinsics, as Eigen uses them, for a
// mistake.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wuninitialized"

#include "sph/pressure/multigrid.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "sph/pressure/coarse_rows.hpp"
#include "sph/pressure/near_rows.hpp"
#include "sph/pressure/systems.hpp"

using namespace vortree;
using sph::SlicedRows;

namespace {

Eigen::MatrixXd dense(const SlicedRows& a, std::size_t columns) {
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(a.rows, columns);
  for (std::size_t i = 0; i < a.rows; ++i)
    a.for_row(i, [&](std::size_t j, float value) { all(i, j) += value; });
  return all;
}

// A matrix in slices, what is near of it, what ties its rows, its aggregates and how they are
// interpolated.
struct TwoLevels {
  sph::Multigrid multigrid;
  SlicedRows a;
  sph::RowsMaker maker;
  sph::RowTies ties;
  sph::RowAggregates aggregates;
  SlicedRows sums, p, coarse;

  static sph::Multigrid prepared(const sph::SparseRows& rows) {
    sph::Multigrid made;
    made.prepare(test::sliced(rows));
    return made;
  }
  explicit TwoLevels(const sph::SparseRows& rows) : multigrid(prepared(rows)) {
    near_rows(multigrid.matrix(), a);
    find_ties(a, ties);
    aggregates = aggregate(a, ties);
    sum_over(aggregates, maker, sums);
    interpolate(a, ties, aggregates, maker, p);
    coarse_rows(a, sums, p, maker, coarse);
  }
};

sph::kernel::SlicedColumn any_column(const SlicedRows& a) {
  test::Chance chance(5);
  sph::kernel::SlicedColumn x(a.padded());
  for (std::size_t i = 0; i < a.rows; ++i) x[i] = static_cast<float>(chance.real() - 0.5);
  return x;
}

constexpr double float_rounding = 6e-8;

}  // namespace

TEST_CASE("rows in slices are the rows, and lanes sum them as one after the other does") {
  const sph::SparseRows rows = test::walled_rows(21);  // no whole number of slices
  const sph::Multigrid multigrid = TwoLevels::prepared(rows);
  const SlicedRows& a = multigrid.matrix();
  REQUIRE(a.rows == rows.size());
  const auto x = any_column(a);
  sph::kernel::SlicedColumn y(a.padded()), differences(a.padded());
  sph::kernel::for_slices(a, x, [&](std::size_t i, Singles sums) { store(y.data() + i, sums); });
  sph::kernel::for_slices_of_differences(
      a, x, [&](std::size_t i, Singles sums) { store(differences.data() + i, sums); });
  for (std::size_t i = 0; i < a.rows; ++i) {
    double sum = rows.diagonal[i] * x[i], all = rows.diagonal[i];
    double size = std::abs(rows.diagonal[i]);
    for (int k = rows.start[i]; k < rows.start[i + 1]; ++k) {
      sum += rows.value[k] * x[rows.index[k]], all += rows.value[k];
      size += std::abs(rows.value[k]);
    }
    // Each value, each product and each sum is rounded; numbers are at most 1/2.
    const double bound = (a.width[i] + 2) * float_rounding * size;
    REQUIRE(std::abs(y[i] - sum) < bound);
    REQUIRE(std::abs(differences[i] - (sum - all * x[i])) < 2 * bound);
  }
}

TEST_CASE("what is near of a matrix keeps the sums of rows, and long waves within a tenth") {
  for (const auto& rows : {test::walled_rows(40), test::pinned_rows(40)}) {
    const TwoLevels levels(rows);
    const SlicedRows &whole = levels.multigrid.matrix(), &near = levels.a;
    std::size_t places = 0, all = 0;
    for (std::size_t i = 0; i < near.rows; ++i) {
      double sum = 0, size = 0;
      whole.for_row(i, [&](std::size_t, float value) { sum += value, size += std::abs(value); });
      near.for_row(i, [&](std::size_t, float value) { sum -= value; });
      REQUIRE(std::abs(sum) < 2 * whole.width[i] * float_rounding * size);
      places += near.width[i], all += whole.width[i];
    }
    CHECK(places < 0.6 * all);
    sph::kernel::SlicedColumn wave(near.padded()), of_near(near.padded()), of_whole(near.padded());
    for (std::size_t i = 0; i < near.rows; ++i) wave[i] = std::sin(6.28F * i / near.rows);
    const auto multiply = [&](const SlicedRows& a, auto& to) {
      sph::kernel::for_slices_of_differences(
          a, wave, [&](std::size_t i, Singles sums) { store(to.data() + i, sums); });
    };
    multiply(whole, of_whole), multiply(near, of_near);
    double both = 0, own = 0;
    for (std::size_t i = 0; i < near.rows; ++i)
      both += of_near[i] * of_whole[i], own += of_whole[i] * of_whole[i];
    CHECK(both == Approx(own).epsilon(0.1));
  }
}

TEST_CASE("pairs side by side and doubles have the same products as floats one by one") {
  const sph::SparseRows rows = test::walled_rows(21);
  const sph::SlicedDoubles doubles = test::sliced(rows);
  const sph::Multigrid multigrid = TwoLevels::prepared(rows);
  const SlicedRows& a = multigrid.matrix();
  const auto x = any_column(a);
  sph::kernel::SlicedPairs pairs(2 * a.padded()), of_pairs(2 * a.padded());
  std::vector<double> wide(x.begin(), x.end()), of_doubles(a.padded());
  for (std::size_t i = 0; i < a.padded(); ++i) pairs[2 * i] = x[i], pairs[2 * i + 1] = -2 * x[i];
  sph::kernel::for_slices_of_pairs(
      a, pairs.data(), [&](std::size_t i, Singles sums) { store(of_pairs.data() + 2 * i, sums); });
  sph::kernel::for_slices<true>(
      doubles, wide.data(), [&](std::size_t i, Lanes sums) { store(of_doubles.data() + i, sums); });
  for (std::size_t i = 0; i < a.rows; ++i) {
    double sum = 0, size = 0;
    for (int k = rows.start[i]; k < rows.start[i + 1]; ++k)
      sum += rows.value[k] * (wide[rows.index[k]] - wide[i]), size += std::abs(rows.value[k]);
    const double bound = 2 * (a.width[i] + 2) * size;  // numbers are at most 1/2
    REQUIRE(std::abs(of_doubles[i] - sum) <= bound * 1.2e-16);
    REQUIRE(std::abs(of_pairs[2 * i] - sum) <= bound * float_rounding);
    REQUIRE(std::abs(of_pairs[2 * i + 1] + 2 * sum) <= 2 * bound * float_rounding);
  }
}

TEST_CASE("aggregates hold each row once, but for those that stand alone") {
  const TwoLevels levels(test::walled_rows(30));
  std::vector<int> times(levels.a.rows);
  for (std::size_t i = 0; i < levels.aggregates.count; ++i) {
    CHECK(levels.sums.width[i] >= 1);
    levels.sums.for_row(i, [&](std::size_t j, float) { ++times[j]; });
  }
  for (std::size_t i = 0; i < levels.a.rows; ++i) CHECK(times[i] == (levels.ties.alone[i] ? 0 : 1));
  CHECK(levels.aggregates.count < levels.a.rows / 5);
}

TEST_CASE("constants are interpolated as constants, and a coarse matrix is R A P") {
  const TwoLevels levels(test::pinned_rows(30));
  const std::size_t n = levels.a.rows, m = levels.aggregates.count;
  const Eigen::MatrixXd p = dense(levels.p, m), a = dense(levels.a, n);
  CHECK((p.rowwise().sum().array() - 1).abs().maxCoeff() < 20 * float_rounding);
  const Eigen::MatrixXd twin = dense(levels.sums, n) * a * p;
  CHECK((dense(levels.coarse, m) - twin).cwiseAbs().maxCoeff() <
        100 * float_rounding * a.cwiseAbs().rowwise().sum().maxCoeff());
}

TEST_CASE("a cycle takes most of an error away, and zero from zero") {
  for (const auto& rows : {test::walled_rows(40), test::pinned_rows(40)}) {
    sph::Multigrid multigrid = TwoLevels::prepared(rows);
    const SlicedRows& a = multigrid.matrix();
    const auto x = any_column(a);
    sph::kernel::SlicedColumn b(a.padded()), found(a.padded());
    multigrid.cycle(b, found);
    CHECK(found == b);
    sph::kernel::for_slices(a, x, [&](std::size_t i, Singles sums) { store(b.data() + i, sums); });
    multigrid.cycle(b, found);
    double before = 0, after = 0;
    sph::kernel::for_slices_of_differences(a, found, [&](std::size_t i, Singles sums) {
      for (int k = 0; k < single_count; ++k)
        before += b[i + k] * b[i + k], after += std::pow(b[i + k] - sums[k], 2);
    });
    CHECK(after < 0.25 * before);
  }
}
