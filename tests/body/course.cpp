#include "body/course.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "body/motion.hpp"

using namespace vortree;
using body::Course;
using body::Jets;

namespace {

const double pi = std::numbers::pi;

std::vector<double> even(double end, int steps) {
  std::vector<double> t;
  for (int i = 0; i <= steps; ++i) t.push_back(end * i / steps);
  return t;
}

Jets known(const std::vector<double>& t, auto f) {
  std::vector<double> values;
  for (const double at : t) values.push_back(f(at));
  return body::known_evenly(std::move(values), t[1] - t[0]);
}

Jets none(const std::vector<double>& t) {
  return known(t, [](double) { return 0.0; });
}

/// x = sin t, y = 0, by steps of h.
Course sine(double h) {
  const std::vector<double> t = even(8, static_cast<int>(std::lround(8 / h)));
  return {t, {known(t, [](double s) { return std::sin(s); }), none(t), none(t)}, {}};
}

/// The largest error of place and acceleration, away from the ends.
std::pair<double, double> errors(const Course& course) {
  double place = 0, acceleration = 0;
  for (double t = 1; t < 7; t += 0.0371) {
    place = std::max(place, std::abs(course.at(t).place.x - std::sin(t)));
    acceleration = std::max(acceleration, std::abs(course.at(t).acceleration.x + std::sin(t)));
  }
  return {place, acceleration};
}

}  // namespace

TEST_CASE("derivatives by nine neighbors are exact on polynomials of degree eight, at ends too") {
  const std::vector<double> t = even(1, 12);
  const Jets jets = known(t, [](double s) { return std::pow(s - 0.3, 8); });
  for (std::size_t i = 0; i < t.size(); ++i) {
    CHECK(jets.first[i] == Approx(8 * std::pow(t[i] - 0.3, 7)).margin(1e-12));
    CHECK(jets.second[i] == Approx(56 * std::pow(t[i] - 0.3, 6)).margin(1e-9));
  }
  for (const double second : known(t, [](double) { return 7.1; }).second) CHECK(second == 0);
}

TEST_CASE("between known times a course is met to the sixth power of the step, as promised") {
  const auto [coarse, coarse_bend] = errors(sine(0.2));
  const auto [fine, fine_bend] = errors(sine(0.1));
  CHECK(coarse < std::pow(0.2, 6) / 300);
  CHECK(coarse_bend < std::pow(0.2, 4) / 20);
  CHECK(coarse / fine == Approx(64).epsilon(0.15));
  CHECK(coarse_bend / fine_bend == Approx(16).epsilon(0.15));
}

TEST_CASE("a spline through uneven times is a cubic where there is one, and smooth") {
  const std::vector<double> t{-0.5, 0, 0.3, 1, 1.2, 2, 2.1};
  std::vector<double> cubic;
  for (const double s : t) cubic.push_back(2 - s + 3 * s * s * s);
  const Jets jets = body::spline_through(t, cubic);
  for (std::size_t i = 0; i < t.size(); ++i) {
    CHECK(jets.first[i] == Approx(-1 + 9 * t[i] * t[i]).margin(1e-11));
    CHECK(jets.second[i] == Approx(18 * t[i]).margin(1e-10));
  }
  const Jets flat = body::spline_through(t, std::vector<double>(t.size()));
  const Course course(t, {body::spline_through(t, {0, 1, -1, 0, 2, 1, 0}), flat, flat}, {});
  for (std::size_t i = 1; i + 1 < t.size(); ++i) {
    const body::Kinematics before = course.at(t[i] - 1e-9), after = course.at(t[i] + 1e-9);
    CHECK(before.velocity.x == Approx(after.velocity.x).margin(1e-6));
    CHECK(before.acceleration.x == Approx(after.acceleration.x).margin(1e-4));
  }
}

TEST_CASE("a body that turns about a pivot keeps its pivot, and its centre's derivatives are so") {
  const std::vector<double> t = even(2, 400);
  const Vec2 about{-0.25, 0.1};
  const Course course(t,
                      {known(t, [](double s) { return 0.1 * std::sin(2 * s); }),
                       known(t, [](double s) { return 0.2 * s * s; }),
                       known(t, [](double s) { return 0.5 * std::cos(3 * s); })},
                      about);
  CHECK(course.turns());
  for (const double s : {0.1, 0.77, 1.9}) {
    const body::Kinematics now = course.at(s);
    const Vec2 pivot = now.place + Turn(now.angle)(about);
    CHECK(pivot.x == Approx(about.x + 0.1 * std::sin(2 * s)).epsilon(1e-9));
    CHECK(pivot.y == Approx(about.y + 0.2 * s * s).epsilon(1e-9));
    CHECK(now.rate == Approx(-1.5 * std::sin(3 * s)).epsilon(1e-8));
    CHECK(now.spin_up == Approx(-4.5 * std::cos(3 * s)).margin(1e-6));
    const double h = 1e-4;
    const body::Kinematics later = course.at(s + h), earlier = course.at(s - h);
    const Vec2 velocity = 1 / (2 * h) * (later.place - earlier.place);
    const Vec2 acceleration = 1 / (2 * h) * (later.velocity - earlier.velocity);
    CHECK(now.velocity.x == Approx(velocity.x).margin(1e-6));
    CHECK(now.velocity.y == Approx(velocity.y).margin(1e-6));
    CHECK(now.acceleration.x == Approx(acceleration.x).margin(1e-5));
    CHECK(now.acceleration.y == Approx(acceleration.y).margin(1e-5));
  }
}

TEST_CASE("what a scene says of a motion adds up: plunge, spin and course") {
  const std::vector<double> t = even(1, 20);
  const Course along(t, {known(t, [](double s) { return 3 * s; }), none(t), none(t)}, {});
  CHECK_FALSE(along.turns());
  const body::Motion motion{{{0, 0.2}, 1}, {2}, along};
  const body::Kinematics now = motion.at(0.5);
  CHECK(now.place.x == Approx(1.5));
  CHECK(now.place.y == Approx(0.2 * std::cos(pi)));
  CHECK(now.velocity.x == Approx(3));
  CHECK(now.angle == Approx(1));
  CHECK(now.rate == 2);
  CHECK(motion.turns());
  CHECK_FALSE(body::Motion{}.moves());
  CHECK(body::Motion{}.at(3).place == Vec2{});
}
