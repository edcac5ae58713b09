#include <catch2/catch.hpp>
#include <cmath>

#include "exact/lamb_oseen.hpp"
#include "vortex/blobs/lattice.hpp"
#include "vortex/flows.hpp"
#include "vortex/transport/particle_exchange.hpp"
#include "vortex/transport/random_walk.hpp"
#include "vortex/wall/vorticity.hpp"

using namespace vortree;
using vortex::Blobs;

namespace {

constexpr double nu = 1e-2;
const exact::LambOseen oseen{1, 0.2, nu};

/// The largest error of the vorticity along a ray, relative to the exact peak.
double error(const Blobs& blobs, double time) {
  std::vector<double> x, y, omega(40);
  for (int k = 0; k < 40; ++k) {
    x.push_back(0.011 * k);
    y.push_back(0.004 * k);
  }
  vorticity(blobs, nullptr, {x, y}, omega);
  double worst = 0;
  for (int k = 0; k < 40; ++k)
    worst = std::max(worst, std::abs(omega[k] - oseen.vorticity(std::hypot(x[k], y[k]), time)));
  return worst / oseen.vorticity(0, time);
}

double after_exchange(double epsilon, double dt) {
  const double h = 0.8 * epsilon, end = 0.5;
  Blobs blobs = vortex::gaussian_vortex({}, 1, 0.2, epsilon, h);
  for (int k = 0; k < std::lround(end / dt); ++k)
    vortex::exchange_strength(blobs, nu, dt, epsilon, h * h);
  double total = 0;
  for (double g : blobs.gamma) total += g;
  CHECK(total == Approx(1).epsilon(1e-13));
  return error(blobs, end);
}

}  // namespace

TEST_CASE("particle strength exchange is of second order in the core, and keeps circulation") {
  const double coarse = after_exchange(0.08, 0.05), fine = after_exchange(0.04, 0.05);
  CHECK(std::log2(coarse / fine) == Approx(2).margin(0.35));
  CHECK(fine < 0.01);
}

TEST_CASE("particle strength exchange is refused where it is unstable") {
  Blobs blobs = vortex::gaussian_vortex({}, 1, 0.2, 0.04, 0.04);
  CHECK_THROWS_AS(vortex::exchange_strength(blobs, 1, 1, 0.04, 0.0016), std::invalid_argument);
}

TEST_CASE("a random walk spreads by 4 nu t, with an error of n^-1/2, and repeats itself") {
  // The mean square deviation of the second moment's growth over many seeds.
  const auto deviation = [](int n) {
    double sum = 0;
    for (int seed = 0; seed < 400; ++seed) {
      Blobs blobs;
      for (int i = 0; i < n; ++i) blobs.append({}, 1.0 / n, 0.1);
      for (int k = 0; k < 4; ++k) vortex::random_walk(blobs, nu, 0.1, seed, k);
      const double grown = invariants(blobs, nullptr).second - 0.01;
      sum += std::pow(grown / (4 * nu * 0.4) - 1, 2);
    }
    return std::sqrt(sum / 400);
  };
  // One walker's square distance is as wide as its mean.
  CHECK(deviation(25) == Approx(1.0 / 5).epsilon(0.12));
  CHECK(deviation(400) == Approx(1.0 / 20).epsilon(0.12));

  Blobs one = test::cloud(100, 0.1, 0.2), two = one, other = one;
  vortex::random_walk(one, nu, 0.1, 7, 3);
  vortex::random_walk(two, nu, 0.1, 7, 3);
  vortex::random_walk(other, nu, 0.1, 7, 4);
  CHECK(one == two);
  CHECK_FALSE(one == other);
}
