#include "flow/paths/flow_map.hpp"

#include <omp.h>

#include <algorithm>
#include <catch2/catch.hpp>

#include "body/shapes/circle.hpp"
#include "flow/paths/pictures_of.hpp"

using namespace vortree;
using namespace vortree::test;

namespace {

constexpr double pi = std::numbers::pi;

/// Turns about (0.5, 0.5), faster and slower in time, so that the angle at time t is known.
Vec2 unsteady_turn(Vec2 at, double t) {
  return (1 + 0.5 * std::sin(3 * t)) * Vec2{0.5 - at.y, at.x - 0.5};
}
double angle_at(double t) {
  return t + (1 - std::cos(3 * t)) / 6;
}

Vec2 turned(Vec2 at, double angle) {
  const Vec2 d = at - Vec2{0.5, 0.5};
  return {0.5 + std::cos(angle) * d.x - std::sin(angle) * d.y,
          0.5 + std::sin(angle) * d.x + std::cos(angle) * d.y};
}

const std::vector<Vec2> some{{0.5, 0.9}, {0.3, 0.4}, {0.55, 0.5}, {0.7, 0.75}};

double error_of_turn(double interval) {
  const auto grid = square(11);
  const int count = static_cast<int>(std::lround(4 / interval)) + 1;
  const auto pictures = pictures_of(grid, interval, count, unsteady_turn);
  const auto ends = flow::flow_map(some, pictures, {grid, {}}, 0.1, 3.9);
  double most = 0;
  for (std::size_t k = 0; k < some.size(); ++k)
    most = std::max(most, length(ends[k] - turned(some[k], angle_at(3.9) - angle_at(0.1))));
  return most;
}

/// Taylor's cells, whose paths close.
Vec2 cells(Vec2 at, double) {
  return {std::sin(pi * at.x) * std::cos(pi * at.y), -std::cos(pi * at.x) * std::sin(pi * at.y)};
}

double error_of_cells(int points) {
  const auto grid = square(points);
  const auto pictures = pictures_of(grid, 0.25, 9, cells);
  const auto ends = flow::flow_map(some, pictures, {grid, {}}, 0, 2);
  double most = 0;
  for (std::size_t k = 0; k < some.size(); ++k) {
    Vec2 x = some[k];  // Euler's steps, extrapolated: another path to the same end
    Vec2 coarse = x, fine = x;
    const int steps = 20000;
    for (int i = 0; i < steps; ++i) coarse += 2.0 / steps * cells(coarse, 0);
    for (int i = 0; i < 2 * steps; ++i) fine += 1.0 / steps * cells(fine, 0);
    most = std::max(most, length(ends[k] - (2 * fine - coarse)));
  }
  return most;
}

}  // namespace

TEST_CASE("paths are of fourth order in the time between pictures") {
  const double coarse = error_of_turn(0.2), fine = error_of_turn(0.1);
  CAPTURE(coarse, fine);
  CHECK(halved(coarse, fine) > 3.5);
  CHECK(fine < 1e-4);
}

TEST_CASE("paths are of fourth order in the spacing of pictures") {
  const double coarse = error_of_cells(11), fine = error_of_cells(21), finest = error_of_cells(41);
  CAPTURE(coarse, fine, finest);
  CHECK(halved(coarse, finest) / 2 > 3.5);
  CHECK(finest < 1e-5);
}

TEST_CASE("back in time fluid comes from where forward it goes to") {
  const auto grid = square(21);
  const auto pictures = pictures_of(grid, 0.1, 31, unsteady_turn);
  const flow::VelocityAnywhere velocity(grid, {});
  const auto there = flow::flow_map(some, pictures, velocity, 0.25, 2.85),
             back = flow::flow_map(there, pictures, velocity, 2.85, 0.25);
  for (std::size_t k = 0; k < some.size(); ++k) {
    CHECK(length(there[k] - some[k]) > 0.01);
    // What RK4 does there and back: dt^4 of a step of 0.08 rad at most, 2.6 long.
    CHECK(length(back[k] - some[k]) < 1e-6);
  }
}

TEST_CASE("steps stop at every picture, and none leads farther than a spacing") {
  const auto grid = square(11);
  const auto pictures = pictures_of(grid, 0.5, 5, [](Vec2, double t) {
    return Vec2{0.25 * (1 + t), 0};
  });
  for (const auto& [from, to] : {std::pair{0.2, 1.7}, std::pair{1.7, 0.2}}) {
    const auto times = flow::steps_between(pictures, grid.spacing, from, to);
    CHECK(times.front() == from);
    CHECK(times.back() == to);
    for (const double picture : {0.5, 1.0, 1.5}) CHECK(std::ranges::count(times, picture) == 1);
    for (std::size_t k = 1; k < times.size(); ++k) {
      CHECK((times[k] - times[k - 1]) * (to - from) > 0);
      CHECK(std::abs(times[k] - times[k - 1]) * 0.75 <= grid.spacing * (1 + 1e-12));
    }
  }
}

TEST_CASE("what leaves the window is lost, and so is what begins outside or in a body") {
  const auto grid = square(41, 4, {-2, -2});
  const auto pictures = pictures_of(grid, 0.5, 5, [](Vec2, double) { return Vec2{1, 0}; });
  const body::Bodies disc{{body::circle({}, 0.5), {0, 0}, {}, 100}};
  const auto ends =
      flow::flow_map({{-1.5, 1}, {0.5, 1}, {-2.1, 0}, {0.1, 0}}, pictures, {grid, disc}, 0, 2);
  CHECK(length(ends[0] - Vec2{0.5, 1}) < 1e-12);
  for (int k : {1, 2, 3}) CHECK((std::isnan(ends[k].x) && std::isnan(ends[k].y)));
}

TEST_CASE("beside a plunging wall, in whose frame pictures are, fluid slides along it as it must") {
  // The layer at the wall: velocity along it, growing with the distance, to and fro.
  const double radius = 0.5, shear = 2, turn = 2 * pi;
  const auto along = [&](Vec2 at, double t) {
    const double r = length(at);
    return r < radius ? Vec2{} : shear * (r - radius) / r * std::cos(turn * t) * Vec2{-at.y, at.x};
  };
  const auto grid = square(81, 4, {-2, -2});
  const auto pictures = pictures_of(grid, 1.0 / 40, 45, along);
  const body::Bodies plunging{
      {body::circle({}, radius), {0, 0}, {.plunge = {{0, 0.2}, 1}, .spin = {}}, 100}};
  std::vector<Vec2> places;
  const std::vector<double> off{1e-6, 0.001, 0.01, 0.03, 0.1, 0.2};  // spacing: 0.05
  for (const double d : off) places.push_back({0, radius + d});
  const auto ends = flow::flow_map(places, pictures, {grid, plunging}, 0, 0.25);
  for (std::size_t k = 0; k < off.size(); ++k) {
    const double r = radius + off[k], angle = shear * off[k] / r / turn;
    CAPTURE(off[k], ends[k].x, ends[k].y);
    // Of the parabola over two layers of 0.14: third derivatives of d/r, 6 R/r^4, of the way.
    CHECK(length(ends[k] - r * Vec2{-std::sin(angle), std::cos(angle)}) < 0.01 * r * angle + 1e-12);
  }
}

TEST_CASE("paths are the same bits by one thread and by two") {
  const auto grid = square(31);
  const auto pictures = pictures_of(grid, 0.1, 21, unsteady_turn);
  std::vector<Vec2> many;
  for (int k = 0; k < 5000; ++k) many.push_back({0.1 + 0.8 * k / 5000, 0.5 + 0.3 * std::sin(k)});
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const auto one = flow::flow_map(many, pictures, {grid, {}}, 0, 2);
  omp_set_num_threads(2);
  const auto two = flow::flow_map(many, pictures, {grid, {}}, 0, 2);
  omp_set_num_threads(before);
  const auto same = [](Vec2 a, Vec2 b) {
    return (a.x == b.x && a.y == b.y) || (std::isnan(a.x) && std::isnan(b.x));
  };
  CHECK(std::ranges::equal(one, two, same));
}
