#include <catch2/catch.hpp>
#include <string>

#include "exact/lamb_oseen.hpp"
#include "flows.hpp"
#include "vortex/blobs/lattice.hpp"
#include "vortex/step.hpp"
#include "vortex/wall/vorticity.hpp"

using namespace vortree;
using vortex::Blobs;
using vortex::Problem;

namespace {

constexpr double nu = 1e-3;
const exact::LambOseen oseen{1.0, 0.2, nu};
const auto direct = fmm::Options{.cores = fmm::Cores::mean, .method = fmm::SumMethod::direct};

Problem free_vortex(double sigma_max, double tolerance) {
  return {.flow = {{}, nu},
          .dt = 0.02,
          .scheme = flow::Scheme::rk4,
          .sigma_0 = 0.04,
          .splitting = {sigma_max},
          .merging = {.tolerance = tolerance, .sigma_max = 1.1 * sigma_max},
          .sums = direct};
}

Blobs after(Blobs blobs, const Problem& problem, int steps) {
  for (int k = 0; k < steps; ++k) step(blobs, problem, k, [](std::string_view) {});
  return blobs;
}

struct Points {
  std::vector<double> x, y;
};

/// Points on spokes out to three widths of the vortex.
Points spokes() {
  Points points;
  for (int k = 0; k < 60; ++k) {
    const double r = 0.01 * (k + 1), theta = 2.4 * k;
    points.x.push_back(r * std::cos(theta));
    points.y.push_back(r * std::sin(theta));
  }
  return points;
}

struct Errors {
  double vorticity, velocity;  // the largest, relative to the largest exact value
};

Errors errors(const Blobs& blobs, const Problem& problem, double time) {
  const Points at = spokes();
  std::vector<double> omega(at.x.size());
  vorticity(blobs, nullptr, {at.x, at.y}, omega);
  const auto u = velocity_at({at.x, at.y}, blobs, problem);
  Errors error{};
  double fastest = 0;
  for (std::size_t k = 0; k < omega.size(); ++k) {
    const double r = std::hypot(at.x[k], at.y[k]), swirl = oseen.swirl(r, time);
    error.vorticity = std::max(error.vorticity, std::abs(omega[k] - oseen.vorticity(r, time)));
    error.velocity = std::max(
        error.velocity, std::hypot(u.u[k] + swirl * at.y[k] / r, u.v[k] - swirl * at.x[k] / r));
    fastest = std::max(fastest, swirl);
  }
  return {error.vorticity / oseen.vorticity(0, time), error.velocity / fastest};
}

}  // namespace

TEST_CASE("a Gaussian vortex cut into a lattice of blobs is itself again, to 3e-4") {
  const Blobs blobs = vortex::gaussian_vortex({}, 1, 0.2, 0.04, 0.04);
  const Errors error = errors(blobs, free_vortex(1, 0), 0);
  CHECK(error.vorticity < 3e-4);
  CHECK(error.velocity < 3e-5);
  const vortex::Invariants whole = invariants(blobs, nullptr);
  CHECK(whole.circulation == Approx(1).epsilon(1e-14));
  CHECK(whole.second == Approx(0.2 * 0.2).epsilon(1e-8));
  CHECK_THROWS_AS(vortex::gaussian_vortex({}, 1, 0.2, 0.2, 0.04), std::invalid_argument);
  CHECK_THROWS_AS(vortex::gaussian_vortex({}, 1, 0.2, 0.04, 0), std::invalid_argument);
}

TEST_CASE("a lattice errs by its first four harmonics, exp(-(pi sigma/h)^2) each") {
  const double narrowed = 1 - 0.04 * 0.04 / (0.2 * 0.2);  // the product of the cores' spectra
  const auto error = [](double h) {
    return errors(vortex::gaussian_vortex({}, 1, 0.2, 0.04, h), free_vortex(1, 0), 0).vorticity;
  };
  for (double spacing : {1.0, 0.9, 0.8})
    CHECK(error(0.04 * spacing) <
          4 * std::exp(-narrowed * std::pow(std::numbers::pi / spacing, 2)));
}

TEST_CASE("Lamb-Oseen: the field within 5e-4 of the exact one, the second moment grows by 4 nu t") {
  const Problem problem = free_vortex(1, 0);
  const Blobs start = vortex::gaussian_vortex({}, 1, 0.2, 0.04, 0.04);
  const Blobs end = after(start, problem, 20);
  CHECK(end.size() == start.size());
  const Errors error = errors(end, problem, 0.4);
  CHECK(error.vorticity < 5e-4);
  CHECK(error.velocity < 1e-4);
  const test::Drift drift = test::drift(invariants(start, nullptr), invariants(end, nullptr));
  CHECK(drift.circulation < 1e-14);
  CHECK(drift.moment < 1e-14);
  CHECK(drift.second == Approx(4 * nu * 0.4).epsilon(1e-6));
}

TEST_CASE("Lamb-Oseen, split and merged: vorticity within 2.5 %, velocity 0.5 %, the same growth") {
  const Problem problem = free_vortex(0.05, 1e-3);
  const Blobs start = vortex::gaussian_vortex({}, 1, 0.2, 0.04, 0.04);
  const Blobs end = after(start, problem, 20);
  REQUIRE(end.size() != start.size());
  const Errors error = errors(end, problem, 0.4);
  CHECK(error.vorticity < 0.025);
  CHECK(error.velocity < 0.005);
  const test::Drift drift = test::drift(invariants(start, nullptr), invariants(end, nullptr));
  CHECK(drift.circulation < 1e-13);
  CHECK(drift.moment < 1e-13);
  CHECK(drift.second == Approx(4 * nu * 0.4).epsilon(1e-6));
}

TEST_CASE("without viscosity nothing diffuses, splits or merges") {
  Problem problem = free_vortex(0.01, 1e9);  // all are too wide, all may merge
  problem.flow.nu = 0;
  const Blobs start = vortex::gaussian_vortex({}, 1, 0.2, 0.04, 0.04);
  const Blobs end = after(start, problem, 3);
  CHECK(end.gamma == start.gamma);
  CHECK(end.sigma == start.sigma);
  CHECK(test::apart(end, start) > 1e-3);  // but all is carried
}

TEST_CASE("direct sum and plan of a tolerance of 1e-10 give the same step") {
  const auto plan = fmm::Options{.tolerance = 1e-10, .cores = fmm::Cores::mean};
  Problem problem = free_vortex(1, 0);
  const Blobs start = test::cloud(1000, 0.02, 0.04);
  const Blobs by_direct = after(start, problem, 1);
  problem.sums = plan;
  CHECK(test::apart(after(start, problem, 1), by_direct) < 1e-9);
}

TEST_CASE("a step names its phases in their order") {
  std::vector<std::string> names;
  Blobs blobs = test::cloud(10, 0.02, 0.04);
  step(blobs, free_vortex(1, 0), 0, [&](std::string_view name) { names.emplace_back(name); });
  CHECK(names == std::vector<std::string>{"convect", "split", "merge"});
}
