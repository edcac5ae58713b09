#include "vortex/along_wall.hpp"

#include <catch2/catch.hpp>

#include "cylinder_flow.hpp"
#include "point_sets.hpp"
#include "vortex/outline.hpp"

using namespace vortree;
using vortex::AlongWall;
using vortex::CoreAtWall;
using vortex::Trace;
using vortex::Vec2;
using vortex::Wall;

namespace {

constexpr double pi = std::numbers::pi, radius = 0.5;

double gaussian(double d, double width) {
  return std::exp(-d * d / (width * width)) / (std::sqrt(pi) * width);
}

/// A Gaussian of width w less w^2/4 of its second derivative.
double kernel(double d, double w) {
  return gaussian(d, w) * (1.5 - d * d / (w * w));
}

/// The trace smoothed by that kernel, by the midpoint rule.
double smoothed(const Trace& trace, double w, double s) {
  if (trace.width == 0) return trace.amount * kernel(s - trace.arc, w);
  constexpr int count = 4000;
  const double step = 20 * trace.width / count;
  double sum = 0;
  for (int k = 0; k < count; ++k) {
    const double d = (k + 0.5) * step - 10 * trace.width;
    sum += step * trace.amount * gaussian(d, trace.width) * kernel(s - trace.arc - d, w);
  }
  return sum;
}

double apart(double a, double b, double perimeter) {
  return std::remainder(a - b, perimeter);
}

double total(const std::vector<double>& values, const Wall& wall) {
  double sum = 0;
  for (double v : values) sum += v * wall.panel_length();
  return sum;
}

/// 2 gamma/(pi sigma_n sigma_t) exp(-n^2/sigma_n^2 - t^2/sigma_t^2) at the wall point of arc s,
/// n and t counted from the core's centre along its own axes.
double folded_there(const CoreAtWall& core, double s) {
  const double theta = (s - core.at.arc) / radius;
  const double t = radius * std::sin(theta);
  const double n = radius * std::cos(theta) - radius - core.at.distance;
  return 2 * core.gamma / (pi * core.across * core.along) *
         std::exp(-n * n / (core.across * core.across) - t * t / (core.along * core.along));
}

}  // namespace

TEST_CASE("what a trace adds is its Gaussian smoothed by a Gaussian freed of its broadening") {
  const Wall wall(vortex::circle({}, radius), 300);
  const AlongWall along(wall);
  const double b = wall.panel_length(), perimeter = 300 * b;
  for (double width : {0.0, 0.3 * b, 4 * b, 12 * b}) {
    for (double arc : {0.2 * b, 100.7 * b, 299.9 * b}) {
      const Trace trace{3, arc, width};
      std::vector<double> values(300);
      along.add(trace, values);
      for (std::size_t i = 0; i < 300; ++i) {
        const double d = apart((i + 0.5) * b, arc, perimeter);
        CHECK(std::abs(values[i] - smoothed({3, 0, width}, 6 * b, d)) < 2e-6 * 3 / (6 * b));
      }
    }
  }
}

TEST_CASE("smoothing leaves of sin(k s) a share (1 + q) exp(-q), q = (k w/2)^2") {
  constexpr int panels = 400;
  const Wall wall(vortex::circle({}, radius), panels);
  const AlongWall along(wall);
  const double b = wall.panel_length();
  for (int mode : {1, 10, 20, 40}) {
    std::vector<double> values(panels);
    const double k = mode / radius, q = std::pow(k * 6 * b / 2, 2);
    for (int i = 0; i < panels; ++i) {
      const double s = (i + 0.5) * b;
      along.add({b * std::sin(k * s), s, 0}, values);
    }
    for (int i = 0; i < panels; ++i)
      CHECK(values[i] == Approx((1 + q) * std::exp(-q) * std::sin(k * (i + 0.5) * b)).margin(3e-6));
  }
}

TEST_CASE("smoothing keeps each amount, beside sharp edges, too") {
  const Wall wall(vortex::naca0012({}, 1, 0.005, 0.1), 500);
  const AlongWall along(wall);
  test::Uniform uniform(5);
  for (int k = 0; k < 200; ++k) {
    std::vector<double> values(wall.panels());
    along.add({2, 500 * wall.panel_length() * uniform(), 0.01 * uniform()}, values);
    CHECK(total(values, wall) == Approx(2).epsilon(1e-5));
  }
}

TEST_CASE(
    "smoothing is over six panels, near bends over a quarter of their radius, and one panel") {
  const Wall circle(vortex::circle({}, radius), 300), foil(vortex::naca0012({}, 1, 0.005, 0), 600);
  for (std::size_t i = 0; i < 300; ++i)
    CHECK(AlongWall(circle).smoothed_over(i) == Approx(6 * circle.panel_length()));
  const AlongWall along(foil);
  const double b = foil.panel_length();
  double longest = 0;
  for (std::size_t i = 0; i < 600; ++i) {
    const double bend = std::abs(foil.shape().nearest(foil.middle(i)).curvature);
    const double w = along.smoothed_over(i), next = along.smoothed_over((i + 1) % 600);
    CHECK((w == b || w < 0.2500001 / bend));
    CHECK(std::abs(w - next) < 0.2500001 * b);
    longest = std::max(longest, w);
  }
  CHECK(longest == Approx(6 * b));
}

TEST_CASE("a trace is the folded core at the wall, to the square of its bend") {
  const auto shape = vortex::circle({}, radius);
  for (double across : {0.01, 0.03}) {
    for (double slant : {0.5, 1.0, 2.0}) {
      for (double cores : {0.0, 0.6, 2.0}) {
        const double along = slant * across;
        const vortex::WallPoint at = shape->nearest({0, radius + cores * across});
        const CoreAtWall core{2, at, across, along};
        const Trace seen = trace(core);
        const double peak = 2 * core.gamma / (pi * across * along);
        const double bend = std::pow(along / radius * std::max(slant, 1.0), 2);
        for (double d = -3 * along; d < 3 * along; d += 0.1 * along)
          CHECK(std::abs(seen.amount * gaussian(d, seen.width) - folded_there(core, at.arc + d)) <
                0.2 * bend * peak);
      }
    }
  }
}
