#include "flow/courses.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace vortree;
using Catch::Matchers::Contains;

namespace {

/// From a file of so many rows a unit of time, which says how high the body is.
body::MotionSettings by_file(const std::function<double(double)>& y, double until) {
  std::vector<double> t, values;
  for (int k = 0; k <= 40 * until; ++k) t.push_back(k / 40.0), values.push_back(y(t.back()));
  const std::vector<double> zeros(t.size());
  body::MotionSettings motion{.file = "law.csv"};
  motion.course = {t,
                   {body::spline_through(t, zeros), body::spline_through(t, values),
                    body::spline_through(t, zeros)},
                   {}};
  return motion;
}

double rise(double t) {
  return 0.1 * std::sin(t);
}

}  // namespace

TEST_CASE("a run goes on by the same file of motion, or one that is longer; by no other") {
  flow::Case of;
  of.body.emplace();
  of.motion = by_file(rise, 2);
  flow::State state;
  flow::save_courses(of, 1.5, state);
  CHECK(state.size() == 1);
  CHECK_NOTHROW(flow::hold_courses(of, state));
  of.motion = by_file([](double t) { return t < 1.95 ? rise(t) : 0.2; }, 4);
  CHECK_NOTHROW(flow::hold_courses(of, state));  // a spline feels it 18 rows before by 1e-10 of it
  of.motion = by_file([](double t) { return rise(t) + (t > 1 ? 1e-3 : 0); }, 2);
  CHECK_THROWS_WITH(flow::hold_courses(of, state),
                    Contains("motion.file leads elsewhere than when the run was there: at t = ") &&
                        Contains(" y was "));
  CHECK_NOTHROW(flow::hold_courses(of, {}));  // saved when nobody noted it
}

TEST_CASE("of several bodies the one is named whose file has changed") {
  flow::Case of;
  of.body.emplace();
  of.others.resize(1);
  of.others[0].motion = by_file(rise, 2);
  flow::State state;
  flow::save_courses(of, 1, state);
  of.others[0].motion = by_file([](double t) { return 2 * rise(t); }, 2);
  CHECK_THROWS_WITH(flow::hold_courses(of, state), Contains("body[1].motion.file leads elsewhere"));
  of.others[0].motion->file.reset();  // an expression is told apart by its text
  CHECK_NOTHROW(flow::hold_courses(of, state));
}
