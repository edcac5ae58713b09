#include "sph/motion/time_step.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "sph/motion/momentum.hpp"

using namespace vortree;
using namespace vortree::sph;

TEST_CASE("backward differences are exact on quadratics for steps of any two lengths") {
  const auto f = [](double t) { return 2 - 3 * t + 5 * t * t; };
  const auto rate = [](double t) { return -3 + 10 * t; };
  for (const double dt : {0.1, 0.3})
    for (const double before : {0.05, 0.1, 0.25}) {
      const TimeStep step{dt, dt / before};
      const double t = 0.7;
      const double found =
          (step.b0() * f(t) - step.b1() * f(t - dt) + step.b2() * f(t - dt - before)) / dt;
      CHECK(found == Approx(rate(t)).epsilon(1e-13));
      CHECK(step.b0() - step.b1() + step.b2() == Approx(0).margin(1e-14));
      const auto line = [](double at) { return 4 - 7 * at; };
      CHECK(step.middle(line(t), line(t - before)) == Approx(line(t + dt / 2)).epsilon(1e-14));
    }
}

TEST_CASE("the first step is one of Euler's") {
  const TimeStep step{0.1, 0};
  CHECK(step.b0() == 1);
  CHECK(step.b1() == 1);
  CHECK(step.b2() == 0);
  CHECK(step.middle(3, 1e9) == 3);
}

TEST_CASE("the slope along a wall is of fourth order, around and around") {
  const auto error = [](int n) {
    std::vector<double> omega;
    const double h = 2 * std::numbers::pi / n;
    for (int k = 0; k < n; ++k) omega.push_back(std::sin(2 * h * k));
    double worst = 0;
    for (int k = 0; k < n; ++k)
      worst = std::max(worst, std::abs(slope_along_wall(omega, k, h) - 2 * std::cos(2 * h * k)));
    return worst;
  };
  // 2^5 h^4/30 is the first term that it misses.
  CHECK(error(40) == Approx(32 * std::pow(2 * std::numbers::pi / 40, 4) / 30).epsilon(0.05));
  CHECK(std::log2(error(40) / error(80)) > 3.9);
  CHECK(slope_along_wall(std::vector{1.0, 5.0, 2.0, 7.0}, 1, 0.1) == 0);
  CHECK(slope_along_wall({}, 0, 0.1) == 0);
}
