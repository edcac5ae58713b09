#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "fmm/direct.hpp"
#include "fmm/plan.hpp"
#include "fmm/reference.hpp"
#include "point_sets.hpp"

using namespace vortree;

namespace {

/// Error of the plan at its blobs against the direct sum, which twins.cpp holds to long double.
test::Error error_at_blobs(const test::PointSet& set, const std::vector<double>& sigma,
                           const fmm::Options& options) {
  const fmm::Sources blobs{set.x, set.y, set.gamma, sigma};
  const std::size_t n = set.size();
  std::vector<double> u(n), v(n), exact_u(n), exact_v(n);
  fmm::Plan(blobs, options).velocity(u, v);
  fmm::velocity_direct(blobs, {set.x, set.y, sigma}, options.cores, exact_u, exact_v);
  test::Exact exact;
  for (std::size_t i = 0; i < n; ++i) {
    exact.u.push_back(exact_u[i]);
    exact.v.push_back(exact_v[i]);
    exact.contributions.push_back(std::hypot(exact_u[i], exact_v[i]));
  }
  return test::error_of(u, v, exact);
}

}  // namespace

TEST_CASE("one giant core over everything is never met by a series") {
  test::PointSet set = test::make_points(test::PointKind::uniform, 3000);
  std::vector<double> sigma(set.size(), 1e-4);
  for (const double giant : {0.3, 1.0, 30.0}) {
    for (const fmm::Cores cores : {fmm::Cores::source, fmm::Cores::mean}) {
      CAPTURE(giant, static_cast<int>(cores));
      sigma[1234] = giant;
      set.gamma[1234] = 1e4;  // outweighs all others where its core shows
      const fmm::Options options{.tolerance = 1e-9, .capacity = 10, .cores = cores};
      CHECK(error_at_blobs(set, sigma, options).relative_l2 < 1e-9);
    }
  }
}

TEST_CASE("wide cores on a deep tree are seen whole") {
  const test::PointSet set = test::make_points(test::PointKind::ringwake, 4000);
  for (const double wide : {0.01, 0.1, 1.0}) {
    const std::vector<double> sigma(set.size(), wide);
    for (const fmm::Cores cores : {fmm::Cores::source, fmm::Cores::mean}) {
      CAPTURE(wide, static_cast<int>(cores));
      const fmm::Options options{.tolerance = 1e-8, .capacity = 1, .cores = cores};
      CHECK(error_at_blobs(set, sigma, options).relative_l2 < 1e-8);
    }
  }
}

TEST_CASE("a wide target core is guarded where cores are averaged") {
  const test::PointSet set = test::make_points(test::PointKind::uniform, 2000);
  const fmm::Sources blobs{set.x, set.y, set.gamma, {}};
  const fmm::Plan plan(blobs, {.tolerance = 1e-9, .cores = fmm::Cores::mean});
  const std::vector<double> x{0.1, 0.5, 2.0}, y{0.2, 0.5, 1.0}, sigma{0.5, 1e-3, 3.0};
  std::vector<double> u(3), v(3);
  plan.velocity({x, y, sigma}, u, v);
  const test::Exact exact = test::exact_velocity(blobs, {x, y, sigma}, fmm::Cores::mean);
  CHECK(test::error_of(u, v, exact).largest < 1e-9);
}

TEST_CASE("velocity_bare sees the same sources without their cores") {
  const test::PointSet set = test::make_points(test::PointKind::ringwake, 5000);
  const std::vector<double> sigma(set.size(), 0.05), none(20, 0.0);
  const fmm::Plan plan({set.x, set.y, set.gamma, sigma}, {.tolerance = 1e-10});
  const std::vector<double> x = test::every(250, set.x), y = test::every(250, set.y);
  std::vector<double> u(x.size()), v(x.size());
  plan.velocity_bare({x, y}, u, v);
  const test::Exact exact =
      test::exact_velocity({set.x, set.y, set.gamma, {}}, {x, y, {}}, fmm::Cores::source);
  CHECK(test::error_of(u, v, exact).relative_l2 < 1e-10);
}
