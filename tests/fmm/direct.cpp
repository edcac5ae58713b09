#include "fmm/direct.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "fmm/plan.hpp"
#include "point_sets.hpp"

using namespace vortree;
using fmm::SumMethod;

namespace {

constexpr std::size_t n = 2000;
const std::vector<double> x{0.5, 1.5, -0.3}, y{0.2, -0.7, 0.9}, sigma{0.1, 0.0, 0.3};

test::PointSet cored_blobs() {
  test::PointSet set = test::make_points(test::PointKind::ringwake, n);
  test::Uniform uniform(3);
  for (std::size_t i = 0; i < set.size(); ++i) set.sigma.push_back(0.02 * (1 + uniform()));
  return set;
}

/// All that a plan sums: at the blobs u, v, ux, uy, vx; elsewhere u, v, bare u, v, ux, uy, vx, psi.
std::vector<std::vector<double>> all_of(const fmm::Plan& plan) {
  std::vector<std::vector<double>> sums(13, std::vector<double>(x.size()));
  for (int k = 0; k < 5; ++k) sums[k].resize(n);
  const fmm::Targets targets{x, y, sigma};
  plan.velocity_and_gradient(sums[0], sums[1], sums[2], sums[3], sums[4]);
  plan.velocity(targets, sums[5], sums[6]);
  plan.velocity_bare({x, y}, sums[7], sums[8]);
  plan.gradient(targets, sums[9], sums[10], sums[11]);
  plan.stream_function(targets, sums[12]);
  return sums;
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double wrong = 0, whole = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    wrong += (a[i] - b[i]) * (a[i] - b[i]);
    whole += b[i] * b[i];
  }
  return std::sqrt(wrong / whole);
}

}  // namespace

TEST_CASE("a plan of pairs gives the direct sums bit for bit, and keeps what it was made of") {
  for (const fmm::Cores cores : {fmm::Cores::mean, fmm::Cores::source}) {
    test::PointSet set = cored_blobs();
    const test::PointSet kept = set;
    const fmm::Plan plan(set.blobs(), {.cores = cores, .method = SumMethod::direct});
    std::fill(set.x.begin(), set.x.end(), 0.0);
    const auto sums = all_of(plan);
    std::vector<double> u(n), v(n), ux(n), uy(n), vx(n), psi(x.size());
    const fmm::Sources blobs = kept.blobs();
    fmm::velocity_direct(blobs, {blobs.x, blobs.y, blobs.sigma}, cores, u, v);
    fmm::gradient_direct(blobs, {blobs.x, blobs.y, blobs.sigma}, cores, ux, uy, vx);
    fmm::stream_function_direct(blobs, {x, y, sigma}, cores, psi);
    CHECK((sums[0] == u && sums[1] == v && sums[2] == ux && sums[3] == uy && sums[4] == vx));
    CHECK(sums[12] == psi);
    CHECK(plan.method() == SumMethod::direct);
    CHECK(plan.order() == 0);
    CHECK(plan.tree().cells().empty());
    CHECK(plan.work().cored == n * n);
  }
}

TEST_CASE("the other methods agree with pairs on all that a plan sums") {
  const test::PointSet set = cored_blobs();
  for (const fmm::Cores cores : {fmm::Cores::mean, fmm::Cores::source}) {
    const auto exact =
        all_of(fmm::Plan(set.blobs(), {.cores = cores, .method = SumMethod::direct}));
    for (const SumMethod method : {SumMethod::fmm, SumMethod::boxes}) {
      const auto sums =
          all_of(fmm::Plan(set.blobs(), {.tolerance = 1e-8, .cores = cores, .method = method}));
      for (std::size_t k = 0; k < sums.size(); ++k) {
        CAPTURE(int(method), k);
        const bool slope = (k >= 2 && k < 5) || (k >= 9 && k < 12);
        CHECK(distance(sums[k], exact[k]) < (slope ? 1e-6 : 1e-7));
      }
    }
  }
}
