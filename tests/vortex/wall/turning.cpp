#include "vortex/wall/turning.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "body/shapes/circle.hpp"
#include "body/shapes/ellipse.hpp"
#include "body/shapes/naca0012.hpp"

using namespace vortree;
using vortex::Turning;
using vortex::Wall;

namespace {

const double pi = std::numbers::pi;

/// Velocity of a patch of vorticity 2 that fills an ellipse of half axes a and b along x and y,
/// within it: Kirchhoff.
Vec2 within_ellipse(double a, double b, Vec2 at) {
  return {-2 * a * at.y / (a + b), 2 * b * at.x / (a + b)};
}

/// The same by Biot and Savart, over squares that the ellipse holds.
Vec2 by_squares(double a, double b, Vec2 centre, Vec2 at, int across) {
  const double h = 2 * a / across;
  Vec2 sum;
  for (int i = 0; i < across; ++i)
    for (int j = 0; j < across; ++j) {
      const Vec2 y{-a + (i + 0.5) * h, -a + (j + 0.5) * h};
      if (y.x * y.x / (a * a) + y.y * y.y / (b * b) > 1) continue;
      const Vec2 d = at - centre - y;
      sum += h * h / (pi * dot(d, d)) * left_of(d);
    }
  return sum;
}

Vec2 velocity_of(const Wall& wall, const std::vector<double>& sheet, Vec2 at) {
  const std::vector<double> x{at.x}, y{at.y};
  vortex::Velocities u(1);
  wall.add_velocity(sheet, {.tolerance = 1e-10}, {x, y}, u);
  return {u.u[0], u.v[0]};
}

}  // namespace

TEST_CASE("a circle that turns about its centre leaves no slip, and moves fluid as a vortex") {
  for (const int panels : {64, 65}) {
    const Wall wall(body::circle({}, 0.5), panels);
    const Turning turning(wall);
    for (const double slip : turning.slip) CHECK(slip == Approx(0).margin(1e-13));
    for (const double gamma : turning.sheet) CHECK(gamma == Approx(0.5).epsilon(1e-12));
    CHECK(turning.circulation == Approx(2 * pi / 4).epsilon(1e-12));
    CHECK(std::hypot(turning.moment.x, turning.moment.y) < 1e-13);
  }
}

TEST_CASE("an ellipse that turns about any pivot slips as Kirchhoff's patch does in its frame") {
  const double a = 0.5, b = 0.2;
  const Vec2 centre{0.3, -0.1};
  const Wall wall(body::ellipse(centre, a, b, 0), 200);
  const Turning turning(wall);
  double most = 0;
  for (std::size_t i = 0; i < wall.panels(); ++i) {
    const auto at = [&](double offset) {
      const double arc = (static_cast<double>(i) + offset) * wall.panel_length(0);
      const Vec2 x = wall.shape().point(arc), t = wall.shape().nearest(x).tangent();
      return dot(within_ellipse(a, b, x - centre) - left_of(x), t);
    };
    const double mean =
        (5 * at(0.5 - std::sqrt(0.15)) + 8 * at(0.5) + 5 * at(0.5 + std::sqrt(0.15))) / 18;
    most = std::max(most, std::abs(turning.slip[i] - mean));
  }
  CHECK(most < 1e-5);
  CHECK(turning.circulation == Approx(2 * pi * a * b).epsilon(1e-10));
  CHECK(turning.moment.x == Approx(2 * pi * a * b * centre.x).epsilon(1e-9));
  CHECK(turning.moment.y == Approx(2 * pi * a * b * centre.y).epsilon(1e-9));
}

TEST_CASE("outside, the sheet of a body that turns is the patch that fills it") {
  const double a = 0.5, b = 0.2;
  const Vec2 centre{0.3, -0.1};
  const Wall wall(body::ellipse(centre, a, b, 0), 200);
  const Turning turning(wall);
  double sum = 0;
  for (const double gamma : turning.sheet) sum += gamma * wall.panel_length(0);
  CHECK(sum == Approx(turning.circulation).epsilon(1e-8));
  for (const Vec2 at : {Vec2{0.9, 0}, Vec2{0.3, 0.15}, Vec2{-0.4, 0.5}, Vec2{2, 3}}) {
    const Vec2 sheet = velocity_of(wall, turning.sheet, at),
               patch = by_squares(a, b, centre, at, 2000);
    CAPTURE(at.x, at.y);
    CHECK(sheet.x == Approx(patch.x).margin(1e-4));
    CHECK(sheet.y == Approx(patch.y).margin(1e-4));
  }
}

TEST_CASE("what panels miss of a body that turns falls fast as they are refined") {
  const auto circulation_off = [](int panels) {
    const Wall wall(body::naca0012({0.2, 0}, 1, 0.01, 0.1), panels);
    const Turning turning(wall);
    double sum = 0;
    for (std::size_t i = 0; i < wall.panels(); ++i) sum += turning.sheet[i] * wall.panel_length(i);
    return std::abs(sum / turning.circulation - 1);
  };
  CHECK(circulation_off(800) < 1e-3);
  CHECK(circulation_off(800) < circulation_off(400));
}

TEST_CASE("along the wall a body gains speed as it spins up, less what draws it to the pivot") {
  const Wall wall(body::ellipse({0.3, -0.1}, 0.5, 0.2, 0.4), 100);
  const double dt = 0.01, rate = 1.3, spin_up = 0.7;
  const std::vector<double> gained =
      vortex::gained_along_wall(wall, wall.rings()[0], {{}, spin_up * dt, rate, dt});
  for (std::size_t i = 0; i < wall.panels(); i += 7) {
    const Vec2 x = wall.middle(i);
    const Vec2 a{-spin_up * x.y - rate * rate * x.x, spin_up * x.x - rate * rate * x.y};
    CHECK(gained[i] == Approx(dt * dot(a, wall.tangent(i))).margin(1e-15));
  }
}
