#include <catch2/catch.hpp>

#include "body/shapes/circle.hpp"
#include "vortex/adapt/split_wide.hpp"
#include "vortex/strained_flows.hpp"

using namespace vortree;
using vortex::Blobs;
using vortex::Core;
using vortex::Covariance;
using vortex::Placed;
using vortex::Splitting;

namespace {

const test::FlatWall flat;

Blobs halves(Blobs blobs, const Splitting& splitting, const body::Shape* wall,
             std::uint64_t step = 3) {
  split_wide(blobs, splitting, wall, step);
  return blobs;
}

/// Moments of what blobs are when they act: mean distance from the flat wall, mean square of it,
/// tilt, and mean place and mean square along it.
struct AtWall {
  double circulation = 0, mean = 0, square = 0, tilt = 0, along = 0, along2 = 0;
};
AtWall at_wall(const Blobs& blobs) {
  AtWall sum;
  double cross = 0;
  for (std::size_t i = 0; i < blobs.size(); ++i) {
    const Placed acts = fold(blobs.centre(i), blobs.core(i), &flat);
    const Covariance v = acts.core.covariance({0, 1});
    const double g = blobs.gamma[i], n = acts.centre.y, t = -acts.centre.x;
    sum.circulation += g;
    sum.mean += g * n;
    sum.square += g * (v.nn + n * n);
    cross += g * (v.nt + n * t);
    sum.along += g * t;
    sum.along2 += g * (v.tt + t * t);
  }
  for (double* a : {&sum.mean, &sum.square, &cross, &sum.along, &sum.along2}) *a /= sum.circulation;
  sum.tilt = cross - sum.mean * sum.along;
  return sum;
}

}  // namespace

TEST_CASE("strained blobs split into what has their circulation, centre and whole covariance") {
  for (double most : {0.5, 0.9}) {
    const Blobs blobs = test::strained(test::cloud(1000, 0.05, 0.2), most);
    for (double alpha : {0.5, 0.7, 0.9})
      for (int children : {3, 4, 7}) {
        const Blobs split = halves(blobs, {0.06, alpha, children}, nullptr);
        REQUIRE(split.size() > 2 * blobs.size());
        const test::Drift drift =
            test::drift(invariants(blobs, nullptr), invariants(split, nullptr));
        CHECK(drift.circulation < 1e-14 * test::strength(blobs));
        CHECK(drift.moment < 1e-14 * test::strength(blobs));
        CHECK(test::difference(test::second_moments(blobs), test::second_moments(split)) <
              1e-15 * test::strength(blobs));
        CHECK(test::all_sound(split));
      }
  }
}

TEST_CASE("beside a flat wall splitting keeps mean and mean square of the distance, and the tilt") {
  for (double most : {0.0, 0.2, 0.4})
    for (double alpha : {0.6, 0.7, 0.8}) {
      test::Uniform uniform(17);
      for (int k = 0; k < 500; ++k) {
        Blobs one;
        const double y = k % 10 == 0 ? 0 : 6 * uniform();
        one.append({0.3, y}, 2 * uniform() - 1,
                   Core{1, test::strain(uniform, 1, most * (1 - alpha * alpha))});
        // A Gaussian on the wall, folded, is upright: what leans there leans as a whole.
        const Blobs split = halves(one, {0.9, alpha}, &flat);
        REQUIRE(split.size() == 4);
        const AtWall a = at_wall(one), b = at_wall(split);
        CAPTURE(most, alpha, y, one.xx[0], one.xy[0]);
        CHECK(test::all_sound(split));
        CHECK(b.circulation == Approx(a.circulation).epsilon(1e-14));
        CHECK(std::abs(b.mean - a.mean) < 1e-9);
        CHECK(std::abs(b.along - a.along) < 1e-12);
        CHECK(std::abs(b.square - a.square) < 1e-8);
        CHECK(std::abs(b.along2 - a.along2) < 1e-8);
        CHECK(std::abs(b.tilt - a.tilt) < 1e-8);
      }
    }
}

TEST_CASE(
    "cores strained to a line but for a twentieth split, sound in the free, finite at a wall") {
  test::Uniform uniform(19);
  for (double alpha : {0.5, 0.7, 0.95})
    for (int k = 0; k < 500; ++k) {
      Blobs one;
      one.append({0.3, k % 10 == 0 ? 0 : 6 * uniform()}, 1,
                 Core{1, test::strain(uniform, 1, 0.95)});
      CHECK(test::all_sound(halves(one, {0.9, alpha}, nullptr)));
      const Blobs beside = halves(one, {0.9, alpha}, &flat);
      for (std::size_t i = 0; i < beside.size(); ++i)
        CHECK(std::isfinite(beside.x[i] + beside.y[i] + beside.sigma[i] + beside.xx[i]));
    }
}

TEST_CASE("the mirror image of a strained flow splits into its mirror image") {
  const auto circle = body::circle({}, 0.5);
  const Blobs blobs = test::strained(test::layer(300, 0.5, 0.3, 0.01, 0.06), 0.9);
  for (const body::Shape* wall : {circle.get(), static_cast<body::Shape*>(nullptr)}) {
    const Blobs there = test::mirrored(halves(blobs, {0.03}, wall));
    const Blobs here = halves(test::mirrored(blobs), {0.03}, wall);
    CHECK(test::apart(test::folded_there(here, wall), test::folded_there(there, wall)) <
          1e-8);  // on the wall, the root of round-off
  }
}
