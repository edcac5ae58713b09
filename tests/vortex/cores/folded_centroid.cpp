#include "vortex/cores/folded_centroid.hpp"

#include <catch2/catch.hpp>

#include "body/shapes/circle.hpp"
#include "vortex/cores/folded_core.hpp"
#include "vortex/strained_flows.hpp"

using namespace vortree;
using vortex::Core;
using vortex::Covariance;
using vortex::Placed;

namespace {

const test::FlatWall flat;
constexpr double s2 = 1e-4;  // of all cores here: sigma = 0.01

/// How far a blob is from coming back when it is put around what it acts as: its folded centroid,
/// in cores, and its variance across the wall, relative.
struct Missed {
  double mean = 0, across = 0, other = 0;
};
Missed missed(const Placed& blob, const body::Shape& wall) {
  const Placed acts = fold(blob.centre, blob.core, &wall);
  const Placed back = unfold(acts, &wall);
  const Placed again = fold(back.centre, back.core, &wall);
  const Vec2 n = wall.nearest(blob.centre).normal, off = again.centre - acts.centre;
  const Covariance v = acts.core.covariance(n), w = again.core.covariance(n);
  return {std::hypot(off.x, off.y) / std::sqrt(s2), std::abs(w.nn / v.nn - 1),
          std::max(std::abs(w.nt - v.nt), std::abs(w.tt - v.tt)) / s2};
}
Missed worst(const body::Shape& wall, double top) {
  test::Uniform uniform(5);
  Missed most;
  for (int k = 0; k < 2000; ++k) {
    const double y = 0.05 * uniform();
    const Missed one =
        missed({{0, top + y}, {s2, test::strain(uniform, s2, 0.9 * uniform())}}, wall);
    most.mean = std::max(most.mean, one.mean);
    most.across = std::max(most.across, one.across);
    most.other = std::max(most.other, one.other);
  }
  return most;
}

}  // namespace

TEST_CASE("a blob put around what it acts as acts as before: mean, width and tilt") {
  const Missed at_flat = worst(flat, 0);
  CAPTURE(at_flat.mean, at_flat.across, at_flat.other);
  CHECK(at_flat.mean < 1e-9);
  CHECK(at_flat.across < 1e-8);
  // Into the wall's frame and back, twice: sixteen roundings of no more than a half.
  CHECK(at_flat.other < 16 * 0x1p-53);
  for (double radius : {0.5, 5.0, 1e4}) {
    const Missed curved = worst(*body::circle({}, radius), radius);
    CAPTURE(radius, curved.mean, curved.across, curved.other);
    CHECK(curved.mean < 1e-9);
    CHECK(curved.across < 1e-6);
    // A tilt that the variance across the wall bounds is known as well as that.
    CHECK(curved.other < curved.across + 1e-13);
  }
}

TEST_CASE("no core beside a wall is flat, neither as it acts nor after strain, however hard") {
  const auto wall = body::circle({}, 0.05);
  test::Uniform uniform(7);
  const auto upright = [](const Core& core) { return 2 * core.deviator.size() < core.square; };
  for (int k = 0; k < 5000; ++k) {
    const Placed blob{{0, 0.05 + 0.03 * uniform()},
                      {s2, test::strain(uniform, s2, 0.9 * uniform())}};
    const vortex::Gradient shear{100 * uniform() - 50, 400 * uniform() - 200,
                                 400 * uniform() - 200};
    const Placed acts = fold(blob.centre, blob.core, wall.get());
    const Vec2 way{0.004 * uniform(), -0.01 * uniform()};
    const Placed after =
        unfold(strained(acts, wall->nearest(acts.centre), way, shear, 0.02), wall.get());
    CHECK(upright(acts.core));
    CHECK(upright(after.core));
    CHECK(upright(fold(after.centre, after.core, wall.get()).core));
  }
}
