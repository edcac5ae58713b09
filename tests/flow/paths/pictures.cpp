#include "flow/paths/pictures.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "flow/paths/pictures_of.hpp"

using namespace vortree;
using namespace vortree::test;

namespace {

const flow::PictureGrid small = square(4);

/// The largest error of sin(t) between pictures so far apart.
double error_of_sine(double interval) {
  const auto pictures = pictures_of(
      small, interval, static_cast<int>(std::lround(4 / interval)) + 1, [](Vec2 at, double t) {
        return Vec2{std::sin(t), at.x * std::sin(t)};
      });
  double most = 0;
  for (double t = 0; t <= 4; t += 0.013)
    most = std::max(most, std::abs(flow::between(pictures, t).velocity[0].x - std::sin(t)));
  return most;
}

}  // namespace

TEST_CASE("velocity between pictures is cubic in time, whatever their times") {
  const auto cubic = [](double t) { return Vec2{1 + t * (2 - t * (3 - t)), t * t}; };
  flow::VelocityPictures pictures;
  for (const double t : {0.0, 0.3, 0.4, 1.0, 1.1, 2.0}) pictures.push_back({t, {cubic(t)}});
  for (double t = 0; t <= 2; t += 0.01) {
    const Vec2 found = flow::between(pictures, t).velocity[0];
    // Four weights of size 10 at most.
    CHECK(length(found - cubic(t)) < 1e-14 * 40);
  }
  for (const auto& one : pictures)
    CHECK(length(flow::between(pictures, one.time).velocity[0] - one.velocity[0]) == 0);
}

TEST_CASE("the error between pictures is of fourth order in the time between them") {
  const double coarse = error_of_sine(0.2), fine = error_of_sine(0.1), finest = error_of_sine(0.05);
  CAPTURE(coarse, fine, finest);
  // The next order, of the cubics at either end, has a share of the interval, 0.2.
  CHECK(halved(coarse, fine) == Approx(4).margin(0.4));
  CHECK(halved(fine, finest) == Approx(4).margin(0.2));
}

TEST_CASE("what the cubic misses is foretold: half-way between two pictures of a wave") {
  const double interval = 0.25;
  const auto wave = [](Vec2, double t) { return Vec2{1 + 0.3 * std::cos(4 * t), 0}; };
  const auto pictures = pictures_of(small, interval, 30, wave);
  double most = 0;
  for (int k = 2; k < 27; ++k) {
    const double t = (k + 0.5) * interval;
    const Vec2 exact = wave({}, t);
    most = std::max(most, length(flow::between(pictures, t).velocity[0] - exact) / length(exact));
  }
  const auto told = flow::lost_between(pictures);
  REQUIRE(told);
  // The fourth derivative changes by up to a fifth over the four pictures, the velocity by a half.
  CHECK(*told > 0.5 * most);
  CHECK(*told < 2 * most);
  CHECK_FALSE(flow::lost_between(std::span(pictures).first(4)));
  CHECK_FALSE(flow::lost_between(pictures_of(small, 1, 9, [](Vec2, double) { return Vec2{}; })));
}

TEST_CASE("pictures that cannot serve are refused with the numbers") {
  const auto still = [](Vec2, double) { return Vec2{}; };
  CHECK_THROWS_WITH(flow::between(pictures_of(small, 1, 3, still), 1.5), Catch::Contains("3 pict"));
  CHECK_THROWS_WITH(flow::between(pictures_of(small, 1, 4, still), 3.5), Catch::Contains("3.5"));
  CHECK_THROWS_WITH(flow::between(pictures_of(small, 1, 4, still), NAN), Catch::Contains("nan"));
  auto odd = pictures_of(small, 1, 4, still);
  odd[2].velocity.pop_back();
  CHECK_THROWS_WITH(flow::between(odd, 1), Catch::Contains("15 and 16"));
}
