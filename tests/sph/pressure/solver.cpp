// GCC 12 takes the undefined lanes of its own AVX-512 intrinsics, as Eigen uses them, for a
// mistake.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wuninitialized"

#include <omp.h>

#include <Eigen/SparseLU>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numeric>

#include "sph/pressure/diagonal_dominant.hpp"
#include "sph/pressure/pressure_solver.hpp"
#include "sph/pressure/systems.hpp"

using namespace vortree;
using sph::SparseRows;
using Numbers = std::vector<double>;

namespace {

Eigen::SparseMatrix<double> eigens(const SparseRows& a) {
  std::vector<Eigen::Triplet<double>> all;
  for (int i = 0; i < static_cast<int>(a.size()); ++i) {
    all.emplace_back(i, i, a.diagonal[i]);
    for (int k = a.start[i]; k < a.start[i + 1]; ++k) all.emplace_back(i, a.index[k], a.value[k]);
  }
  Eigen::SparseMatrix<double> matrix(a.size(), a.size());
  matrix.setFromTriplets(all.begin(), all.end());
  return matrix;
}

Numbers any_numbers(std::size_t n, std::uint64_t seed = 1) {
  test::Chance chance(seed);
  Numbers numbers(n);
  for (double& one : numbers) one = chance.real() - 0.5;
  return numbers;
}

double norm(const Numbers& a) {
  double sum = 0;
  for (const double one : a) sum += one * one;
  return std::sqrt(sum);
}

Numbers product(const SparseRows& a, const Numbers& x) {
  Numbers y(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    y[i] = a.diagonal[i] * x[i];
    for (int k = a.start[i]; k < a.start[i + 1]; ++k) y[i] += a.value[k] * x[a.index[k]];
  }
  return y;
}

double residual(const SparseRows& a, const Numbers& b, const Numbers& x) {
  Numbers left = product(a, x);
  for (std::size_t i = 0; i < b.size(); ++i) left[i] -= b[i];
  return norm(left) / norm(b);
}

Numbers direct(const SparseRows& a, const Numbers& b) {
  const Eigen::SparseLU<Eigen::SparseMatrix<double>> factors(eigens(a));
  const Eigen::VectorXd x = factors.solve(Eigen::Map<const Eigen::VectorXd>(b.data(), b.size()));
  return {x.begin(), x.end()};
}

Numbers without_mean(Numbers a) {
  const double mean = std::accumulate(a.begin(), a.end(), 0.0) / a.size();
  for (double& one : a) one -= mean;
  return a;
}

}  // namespace

TEST_CASE("the pressure is that of a direct solve, but for a constant where only a pin holds it") {
  constexpr double tolerance = 1e-9;
  for (const SparseRows& a : {test::walled_rows(30), test::pinned_rows(30)}) {
    // Of any b, the pin would make a constant so large that its rounding fills the residual.
    const Numbers b = product(a, any_numbers(a.size()));
    Numbers x(a.size());
    const sph::SlicedDoubles slices = test::sliced(a);
    sph::PressureSolver solver;
    solver.prepare(slices);
    const auto told = solver.solve(b, x, tolerance, 200);
    CHECK(told.residual <= tolerance);
    CHECK(residual(a, b, x) == Approx(told.residual).epsilon(1e-2));
    Numbers error = direct(a, b);
    for (std::size_t i = 0; i < x.size(); ++i) error[i] -= x[i];
    // Constants apart, the smallest eigenvalue is some (2 pi spacing)^2 of the largest.
    CHECK(norm(without_mean(error)) < 1e3 * tolerance * norm(b));
  }
}

TEST_CASE("a first guess that is good enough is left alone, and zeros have zeros for an answer") {
  const SparseRows a = test::walled_rows(20);
  const sph::SlicedDoubles slices = test::sliced(a);
  sph::PressureSolver solver;
  solver.prepare(slices);
  Numbers b = any_numbers(a.size()), x(a.size());
  solver.solve(b, x, 1e-8, 200);
  const Numbers before = x;
  CHECK(solver.solve(b, x, 1e-7, 200).iterations == 0);
  CHECK(x == before);
  b.assign(a.size(), 0);
  CHECK(solver.solve(b, x, 1e-7, 200).residual == 0);
  CHECK(norm(x) == 0);
}

TEST_CASE("what does not converge says so, with numbers") {
  SparseRows a = test::walled_rows(20);
  const Numbers b = any_numbers(a.size());
  Numbers x(a.size());
  const sph::SlicedDoubles slices = test::sliced(a);
  sph::PressureSolver solver;
  solver.prepare(slices);
  const auto hasty = solver.solve(b, x, 1e-12, 2);
  CHECK(hasty.iterations == 2);
  CHECK(hasty.residual == Approx(residual(a, b, x)).epsilon(1e-6));
  CHECK(hasty.residual > 1e-12);
  test::Chance chance(3);
  for (double& value : a.value) value = chance.real() - 0.5;  // no Laplacian at all
  const sph::SlicedDoubles spoilt = test::sliced(a);
  solver.prepare(spoilt);
  const auto lost = solver.solve(b, x, 1e-12, 8);
  CHECK(std::isfinite(lost.residual));
  CHECK(lost.residual == Approx(residual(a, b, x)).epsilon(1e-3));
}

TEST_CASE("velocities by implicit viscosity, and what is given stays") {
  const SparseRows a = test::walled_rows(30);
  const std::size_t n = a.size();
  const sph::SlicedDoubles slices = test::sliced(a);
  sph::PressureSolver singles;
  singles.prepare(slices);
  Numbers value(n, 1.5), factor(n, 0.1);
  SparseRows twin = a;
  for (std::size_t i = 0; i < n; ++i) {
    if (a.diagonal[i] == -1) value[i] = 1, factor[i] = 0;  // a node
    twin.diagonal[i] = value[i];
    for (int k = a.start[i]; k < a.start[i + 1]; ++k) {
      twin.value[k] *= -factor[i];
      twin.diagonal[i] -= twin.value[k];
    }
  }
  const Numbers bu = any_numbers(n, 2), bv = any_numbers(n, 3);
  Numbers u(n), v(n);
  for (const double tolerance : {1e-4, 1e-7, 1e-11}) {
    u.assign(n, 0), v.assign(n, 0);
    const auto told =
        sph::solve({slices, singles.matrix(), value, factor}, {bu, bv}, {u, v}, tolerance, 100);
    CHECK(told[0].residual <= tolerance);
    CHECK(residual(twin, bu, u) <= told[0].residual * 1.001 + 1e-15);
    CHECK(residual(twin, bv, v) <= told[1].residual * 1.001 + 1e-15);
    for (std::size_t i = 0; i < n; ++i)
      if (factor[i] == 0) REQUIRE(u[i] == Approx(bu[i]).epsilon(2 * tolerance));
  }
  Numbers zero(n);
  sph::solve({slices, singles.matrix(), value, factor}, {zero, bv}, {u, v}, 1e-7, 100);
  CHECK(norm(u) == 0);
}

TEST_CASE("iterations hardly grow with the number of particles") {
  int fewest = 100, most = 0;
  for (const int side : {16, 32, 64, 96}) {
    const SparseRows a = test::walled_rows(side);
    const Numbers b = product(a, any_numbers(a.size()));
    Numbers x(a.size());
    const sph::SlicedDoubles slices = test::sliced(a);
    sph::PressureSolver solver;
    solver.prepare(slices);
    const auto told = solver.solve(b, x, 1e-5, 100);
    CHECK(told.residual <= 1e-5);
    fewest = std::min(fewest, told.iterations), most = std::max(most, told.iterations);
  }
  CHECK(most <= fewest + 4);  // ILU(0) would take four times as many for six times the side
  CHECK(most <= 24);
}

TEST_CASE("the pressure is the same to the last bit for any number of threads") {
  const int all = omp_get_max_threads();
  const SparseRows a = test::walled_rows(80);  // enough rows for threads to share
  const Numbers b = any_numbers(a.size());
  Numbers first;
  for (const int threads : {1, 2, 3}) {
    omp_set_num_threads(threads);
    Numbers x(a.size());
    const sph::SlicedDoubles slices = test::sliced(a);
    sph::PressureSolver solver;
    solver.prepare(slices);
    solver.solve(b, x, 1e-8, 100);
    if (first.empty()) first = x;
    CHECK(x == first);
  }
  omp_set_num_threads(all);
}

TEST_CASE("a few ugly rows are no obstacle") {
  SparseRows a = test::walled_rows(40);
  test::Chance chance(11);
  for (int k = 0; k < 10; ++k) {
    const auto i = static_cast<std::size_t>(chance.whole(0, static_cast<int>(a.size()) - 1));
    for (int m = a.start[i]; m < a.start[i + 1]; ++m) a.value[m] *= 8 * (chance.real() - 0.5);
    a.diagonal[i] *= 0.5;
  }
  const Numbers b = any_numbers(a.size());
  Numbers x(a.size());
  const sph::SlicedDoubles slices = test::sliced(a);
  sph::PressureSolver solver;
  solver.prepare(slices);
  CHECK(solver.solve(b, x, 1e-6, 100).residual <= 1e-6);
}

TEST_CASE("what is no matrix is refused, with numbers") {
  sph::PressureSolver solver;
  const SparseRows rows{{1, 1}, {0, 1, 1}, {1}, {0.5}};
  const sph::SlicedDoubles good = test::sliced(rows);
  CHECK_NOTHROW(solver.prepare(good));
  constexpr std::size_t beside = sph::SlicedDoubles::lanes;  // of row 0
  for (const auto spoil : {+[](sph::SlicedDoubles& a) { a.index[beside] = 2; },
                           +[](sph::SlicedDoubles& a) { a.index[beside] = -1; },
                           +[](sph::SlicedDoubles& a) { a.index[0] = 1; },
                           +[](sph::SlicedDoubles& a) { a.value[1] = 0; },
                           +[](sph::SlicedDoubles& a) { a.value[beside] = std::nan(""); }}) {
    sph::SlicedDoubles bad = good;
    spoil(bad);
    CHECK_THROWS_AS(solver.prepare(bad), std::invalid_argument);
  }
  Numbers x(2), short_x(1), wrong{1, std::numeric_limits<double>::infinity()};
  CHECK_THROWS_AS(solver.solve(x, short_x, 1e-5, 9), std::invalid_argument);
  CHECK_THROWS_AS(solver.solve(wrong, x, 1e-5, 9), std::invalid_argument);
}
