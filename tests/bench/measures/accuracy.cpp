#include "bench/measures/accuracy.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "bench/sets/point_sets.hpp"

using namespace vortree;

namespace {

// Said plainly, in long double.
void check_twin(const bench::PointSet& set) {
  const bench::Exact exact = bench::exact_velocity(set.blobs(), {set.x, set.y, {}}, 40);
  for (std::size_t k = 0; k < exact.targets.size(); ++k) {
    const std::size_t i = exact.targets[k];
    long double u = 0, v = 0, contributions = 0;
    for (std::size_t j = 0; j < set.size(); ++j) {
      const long double dx = static_cast<long double>(set.x[i]) - set.x[j];
      const long double dy = static_cast<long double>(set.y[i]) - set.y[j];
      const long double r2 = dx * dx + dy * dy;
      if (r2 == 0) continue;
      long double weight = set.gamma[j] / (2 * std::numbers::pi_v<long double> * r2);
      if (!set.sigma.empty() && set.sigma[j] > 0)
        weight *= -std::expm1(-r2 / (static_cast<long double>(set.sigma[j]) * set.sigma[j]));
      u -= weight * dy;
      v += weight * dx;
      contributions += std::abs(weight) * std::sqrt(r2);
    }
    REQUIRE(std::abs(exact.u[k] - u) <= 1e-18L * contributions);
    REQUIRE(std::abs(exact.v[k] - v) <= 1e-18L * contributions);
    REQUIRE(exact.contributions[k] == Approx(static_cast<double>(contributions)).epsilon(1e-12));
  }
}

}  // namespace

TEST_CASE("the reference is the plain sum in long double, to its last digits") {
  for (const std::size_t n : {1, 7, 1003}) {
    for (const bench::PointKind kind : bench::every_kind) {
      bench::PointSet set = bench::make_points(kind, n);
      check_twin(set);
      for (std::size_t i = 0; i < n; ++i) set.sigma.push_back(i % 3 == 0 ? 0.0 : 0.01 * (i % 7));
      set.x[n / 2] = set.x[0];
      set.y[n / 2] = set.y[0];
      check_twin(set);
    }
  }
}

TEST_CASE("the error of velocities that are off by a known amount is that amount") {
  // Two vortices of gamma 2 pi at distance 2: each moves the other with 1/2.
  const double gamma = 2 * 3.14159265358979323846;
  const std::vector<double> x{-1, 1}, y{0, 0}, strength{gamma, gamma}, u{0, 0};
  const fmm::Sources blobs{x, y, strength, {}};
  const fmm::Targets targets{x, y, {}};

  const std::vector<double> off{-0.5, 0.5 + 0.125};
  const bench::Exact exact = bench::exact_velocity(blobs, targets);
  const auto error = bench::velocity_error(exact, u, off);
  CHECK(error.relative_l2 == Approx(0.125 / std::sqrt(0.5)));
  CHECK(error.max == Approx(0.25));
  CHECK(error.targets == 2);

  const std::vector<double> broken{-0.5, NAN};
  CHECK(std::isinf(bench::velocity_error(exact, u, broken).max));
  CHECK(std::isinf(bench::velocity_error(exact, u, broken).relative_l2));

  const std::vector<double> wide{2, 2},
      slow{-0.5 * (1 - std::exp(-1.0)), 0.5 * (1 - std::exp(-1.0))};
  CHECK(bench::velocity_error(bench::exact_velocity({x, y, strength, wide}, targets), u, slow).max <
        1e-15);
}
