#include "sph/boundary/smooth_pressure.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tree/clouds.hpp"

using namespace vortree;
using namespace vortree::sph;

namespace {

constexpr double dt = 0.01, memory = 0.2;

}  // namespace

TEST_CASE("What the two routes differ by is followed without lag") {
  SmoothPressure smooth;
  for (int k = 0; k < 1000; ++k) {
    const double t = k * dt;
    const Vec2 by_vorticity{std::sin(t), 3}, pressure{std::sin(t) + 0.5 + 0.2 * t, 2 - 0.1 * t};
    const Vec2 told = smooth(pressure, by_vorticity, dt, memory);
    if (t < 30 * memory) continue;  // a lag of the start is left, exp(-30)
    CHECK(told.x == Approx(pressure.x).margin(1e-11));
    CHECK(told.y == Approx(pressure.y).margin(1e-11));
  }
}

TEST_CASE("White noise of the pressure falls by sqrt(5 dt/(4 memory))") {
  SmoothPressure smooth;
  vortree::test::Chance chance(7);
  double told2 = 0, raw2 = 0;
  for (int k = 0; k < 100'000; ++k) {
    const Vec2 noise{chance.real() - 0.5, 0};
    const double told = smooth(noise, {}, dt, memory).x;
    if (k > 1000) told2 += told * told, raw2 += noise.x * noise.x;
  }
  // Brown's own number for a share a = dt/memory, of which 5 a/4 is the limit; a mean over 5000
  // independent values of told^2, two standard deviations of 2 %.
  const double a = dt / memory, b = 1 - a;
  const double known = a * (1 + 4 * b + 5 * b * b) / std::pow(1 + b, 3);
  CHECK(told2 / raw2 == Approx(known).epsilon(0.05));
  CHECK(known == Approx(1.25 * a).epsilon(0.1));
}

TEST_CASE("The memory is short beside the age of a flow and the period of a motion") {
  CHECK(memory_of_pressure(0.4, 1, 0) == Approx(0.05));
  CHECK(memory_of_pressure(40, 1, 0) == Approx(0.25));
  CHECK(memory_of_pressure(40, 1, 2) == Approx(0.01));
  // Shorter than a step: the pressure as it is.
  SmoothPressure smooth;
  smooth({5, 5}, {}, dt, 0.001);
  CHECK(smooth({1, 2}, {3, 4}, dt, 0.001).x == Approx(1));
}
