#include "flow/paths/velocity_anywhere.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "body/shapes/circle.hpp"
#include "flow/paths/pictures_of.hpp"

using namespace vortree;
using namespace vortree::test;

namespace {

constexpr double radius = 0.5;

body::Bodies disc(Vec2 centre, double spin = 0) {
  return {{body::circle({}, radius), centre, {.plunge = {}, .spin = {spin}}, 100}};
}

double worst(const flow::VelocityAnywhere& found, const flow::VelocityPicture& picture,
             const auto& exact, const auto& places) {
  double most = 0;
  for (const Vec2 at : places) {
    const auto u = found(picture, at);
    REQUIRE(u);
    most = std::max(most, length(*u - exact(at)));
  }
  return most;
}

/// Places on rings around a centre.
std::vector<Vec2> rings(Vec2 centre, double from, double to) {
  std::vector<Vec2> places;
  for (double r = from; r <= to; r += (to - from) / 20)
    for (double theta = 0.01; theta < 6.28; theta += 0.1)
      places.push_back(centre + r * Vec2{std::cos(theta), std::sin(theta)});
  return places;
}

}  // namespace

TEST_CASE("between its points a picture is bicubic, at the edges of its window as well") {
  const flow::PictureGrid grid{{-1, 2}, 0.25, 9, 6};
  const auto exact = [](Vec2 at) {
    return Vec2{at.x * at.x * at.x * at.y, 1 - at.x * at.y * at.y * at.y};
  };
  const auto picture = pictures_of(grid, 1, 1, [&](Vec2 at, double) { return exact(at); }).front();
  const flow::VelocityAnywhere found(grid, {});
  std::vector<Vec2> places;
  for (double x = -1; x <= 1; x += 1.0 / 64)
    for (double y = 2; y <= 3.25; y += 1.0 / 64) places.push_back({x, y});
  // Values up to 35, weights up to 4 a direction.
  CHECK(worst(found, picture, exact, places) < 35 * 16 * 1e-15);
  for (const Vec2 out : {Vec2{-1.001, 2.5}, Vec2{1.001, 2.5}, Vec2{0, 1.999}, Vec2{0, 3.251},
                         Vec2{NAN, 2.5}, Vec2{0, NAN}})
    CHECK_FALSE(found(picture, out));
}

TEST_CASE("its error is of fourth order in the spacing") {
  const auto wave = [](Vec2 at) { return Vec2{std::sin(5 * at.x) * std::cos(4 * at.y), at.y}; };
  std::vector<double> errors;
  for (const int points : {21, 41, 81}) {
    const auto grid = square(points);
    const auto picture = pictures_of(grid, 1, 1, [&](Vec2 at, double) { return wave(at); }).front();
    errors.push_back(
        worst(flow::VelocityAnywhere(grid, {}), picture, wave, rings({0.5, 0.5}, 0.01, 0.4)));
  }
  CAPTURE(errors[0], errors[1], errors[2]);
  CHECK(halved(errors[0], errors[1]) == Approx(4).margin(0.3));
  CHECK(halved(errors[1], errors[2]) == Approx(4).margin(0.3));
}

TEST_CASE("beside a wall the velocity is the wall's own there, and of third order in the spacing") {
  // Around a circle that spins all turns as 1/r; pictures have nothing within.
  const double spin = 3;
  const Vec2 centre{0.1, -0.2};
  const auto exact = [&](Vec2 at) {
    const Vec2 d = at - centre;
    return spin * radius * radius / dot(d, d) * Vec2{-d.y, d.x};
  };
  const auto drawn = [&](Vec2 at, double) {
    return length(at - centre) < radius ? Vec2{} : exact(at);
  };
  std::vector<double> errors;
  for (const int points : {61, 121, 241}) {
    const auto grid = square(points, 4, {-2, -2});
    const auto picture = pictures_of(grid, 1, 1, drawn).front();
    const flow::VelocityAnywhere found(grid, disc(centre, spin));
    errors.push_back(worst(found, picture, exact, rings(centre, radius + 1e-9, radius + 0.5)));
    CHECK(worst(found, picture, exact, rings(centre, radius + 1e-9, radius + 2e-9)) < 1e-7);
    for (const Vec2 in : rings(centre, 0, radius - 1e-9)) CHECK_FALSE(found(picture, in));
  }
  CAPTURE(errors[0], errors[1], errors[2]);
  // Of the parabola: (s - 0) (s - d) (s - 2d) u'''/6, s = 0.42 d, u''' = 6 spin R^2/r^4.
  CHECK(errors[2] < 0.385 * std::pow(std::sqrt(8.0) * 4 / 240, 3) * spin / (radius * radius));
  CHECK(halved(errors[1], errors[2]) > 2.6);
}

TEST_CASE(
    "without the wall's law what pictures have within would be felt: the test above can fail") {
  const auto drawn = [](Vec2 at, double) {
    return length(at) < radius ? Vec2{} : Vec2{-at.y, at.x};
  };
  const auto grid = square(61, 4, {-2, -2});
  const auto picture = pictures_of(grid, 1, 1, drawn).front();
  const auto bare = flow::VelocityAnywhere(grid, {})(picture, {radius + 0.01, 0});
  const auto with = flow::VelocityAnywhere(grid, disc({}, 1))(picture, {radius + 0.01, 0});
  REQUIRE((bare && with));
  CHECK(std::abs(bare->y - radius - 0.01) > 0.05);
  CHECK(std::abs(with->y - radius - 0.01) < 1e-12);
}

TEST_CASE("a window that cuts a wall knows no velocity beside the cut, and no wrong one") {
  const auto grid = square(41, 1, {0, 0});
  const auto picture = pictures_of(grid, 1, 1, [](Vec2, double) { return Vec2{1, 0}; }).front();
  const flow::VelocityAnywhere found(grid, disc({0, 0}));
  CHECK_FALSE(found(picture, {0.001, radius - 0.001}));
  CHECK(found(picture, {0.5 * radius, radius}));
  CHECK_THROWS_WITH(flow::VelocityAnywhere(square(3), {}), Catch::Contains("3 x 3"));
}
