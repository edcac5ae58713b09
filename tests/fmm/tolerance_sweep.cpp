#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "fmm/plan.hpp"
#include "fmm/reference.hpp"
#include "point_sets.hpp"

using namespace vortree;

namespace {

/// bare: no cores. even: all cores twice the spacing of the blobs. mixed: from 1e-6 to 1.
enum class Widths { bare, even, mixed };

std::vector<double> widths(Widths kind, std::size_t n) {
  std::vector<double> sigma;
  test::Uniform uniform(99);
  for (std::size_t i = 0; i < n && kind != Widths::bare; ++i) {
    sigma.push_back(kind == Widths::even ? 2.0 / std::sqrt(static_cast<double>(n))
                                         : std::pow(10.0, -6.0 * uniform()));
  }
  return sigma;
}

struct Case {
  test::PointSet set;
  std::vector<double> sigma, x, y, target_sigma;
  fmm::Cores cores;

  Case(test::PointKind kind, std::size_t n, Widths width, fmm::Cores pair_cores)
      : set(test::make_points(kind, n)), sigma(widths(width, n)), cores(pair_cores) {
    const std::size_t stride = n / 1000;
    x = test::every(stride, set.x), y = test::every(stride, set.y);
    target_sigma = test::every(stride, sigma);
  }
  [[nodiscard]] fmm::Sources blobs() const { return {set.x, set.y, set.gamma, sigma}; }
  [[nodiscard]] fmm::Targets targets() const { return {x, y, target_sigma}; }
};

void check_sweep(const Case& asked, std::initializer_list<double> tolerances) {
  const test::Exact exact = test::exact_velocity(asked.blobs(), asked.targets(), asked.cores);
  const std::size_t n = asked.set.size(), stride = n / 1000;
  std::vector<double> u(n), v(n), target_u(asked.x.size()), target_v(asked.x.size());
  for (const double tolerance : tolerances) {
    CAPTURE(tolerance);
    const fmm::Plan plan(asked.blobs(), {.tolerance = tolerance, .cores = asked.cores});
    plan.velocity(u, v);
    const test::Error at_blobs =
        test::error_of(test::every(stride, u), test::every(stride, v), exact);
    CHECK(at_blobs.relative_l2 < tolerance);
    CHECK(at_blobs.percentile99 < tolerance);
    plan.velocity(asked.targets(), target_u, target_v);
    const test::Error elsewhere = test::error_of(target_u, target_v, exact);
    CHECK(elsewhere.relative_l2 < tolerance);
    CHECK(elsewhere.percentile99 < tolerance);
  }
}

}  // namespace

TEST_CASE("the error keeps below the tolerance, from 1e-2 to 1e-13, bare vortices") {
  for (const test::PointKind kind : test::every_kind) {
    CAPTURE(test::kind_names[static_cast<int>(kind)]);
    check_sweep(Case(kind, 20000, Widths::bare, fmm::Cores::source),
                {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13});
  }
}

TEST_CASE("the error keeps below the tolerance, from 1e-2 to 1e-13, cores of the spacing") {
  for (const test::PointKind kind : test::every_kind) {
    for (const fmm::Cores cores : {fmm::Cores::source, fmm::Cores::mean}) {
      CAPTURE(test::kind_names[static_cast<int>(kind)], static_cast<int>(cores));
      check_sweep(Case(kind, 10000, Widths::even, cores),
                  {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-9, 1e-12, 1e-13});
    }
  }
}

TEST_CASE("the error keeps below the tolerance, from 1e-2 to 1e-13, cores from 1e-6 to 1") {
  for (const test::PointKind kind : test::every_kind) {
    for (const fmm::Cores cores : {fmm::Cores::source, fmm::Cores::mean}) {
      CAPTURE(test::kind_names[static_cast<int>(kind)], static_cast<int>(cores));
      check_sweep(Case(kind, 10000, Widths::mixed, cores), {1e-2, 1e-4, 1e-6, 1e-9, 1e-13});
    }
  }
}
