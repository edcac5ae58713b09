#include "base/vec2.hpp"

#include <catch2/catch.hpp>

using namespace vortree;

TEST_CASE("a unit vector has length 1 and the direction of its vector, however long that is") {
  const double size = GENERATE(1e-300, 1e-160, 1.0, 1e160, 1e300);
  CAPTURE(size);
  const Vec2 u = unit(size * Vec2{-0.6, 0.8});
  // Three roundings: of the length, of its inverse, of the product.
  CHECK(u.x == Approx(-0.6).epsilon(1e-15));
  CHECK(u.y == Approx(0.8).epsilon(1e-15));
}
