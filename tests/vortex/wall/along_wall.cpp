#include "vortex/wall/along_wall.hpp"

#include <catch2/catch.hpp>

#include "body/shapes/circle.hpp"
#include "body/shapes/naca0012.hpp"
#include "point_sets.hpp"
#include "vortex/cylinder_flow.hpp"

using namespace vortree;
using vortex::AlongWall;
using vortex::CoreAtWall;
using vortex::Trace;
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
  for (std::size_t i = 0; i < wall.panels(); ++i) sum += values[i] * wall.panel_length(i);
  return sum;
}

}  // namespace

TEST_CASE("what a trace adds is its Gaussian smoothed by a Gaussian freed of its broadening") {
  const Wall wall(body::circle({}, radius), 300);
  const AlongWall along(wall);
  const double b = wall.panel_length(0), perimeter = 300 * b;
  for (double width : {0.0, 0.3 * b, 4 * b, 12 * b}) {
    for (double arc : {0.2 * b, 100.7 * b, 299.9 * b}) {
      const Trace trace{3, arc, width};
      std::vector<double> values(300);
      along.add(trace, values);
      for (std::size_t i = 0; i < 300; ++i) {
        const double d = apart((i + 0.5) * b, arc, perimeter);
        CHECK(std::abs(values[i] - smoothed({3, 0, width}, 3 * b, d)) < 2e-6 * 3 / (3 * b));
      }
    }
  }
}

TEST_CASE("smoothing leaves of sin(k s) a share (1 + q) exp(-q), q = (k w/2)^2") {
  constexpr int panels = 400;
  const Wall wall(body::circle({}, radius), panels);
  const AlongWall along(wall);
  const double b = wall.panel_length(0);
  for (int mode : {1, 10, 20, 40}) {
    std::vector<double> values(panels);
    const double k = mode / radius, q = std::pow(k * 3 * b / 2, 2);
    for (int i = 0; i < panels; ++i) {
      const double s = (i + 0.5) * b;
      along.add({b * std::sin(k * s), s, 0}, values);
    }
    for (int i = 0; i < panels; ++i)
      CHECK(values[i] == Approx((1 + q) * std::exp(-q) * std::sin(k * (i + 0.5) * b)).margin(3e-6));
  }
}

TEST_CASE("smoothing keeps each amount, beside sharp edges, too") {
  const Wall wall(body::naca0012({}, 1, 0.005, 0.1), 500);
  const AlongWall along(wall);
  test::Uniform uniform(5);
  for (int k = 0; k < 200; ++k) {
    std::vector<double> values(wall.panels());
    along.add({2, wall.shape().perimeter() * uniform(), 0.01 * uniform()}, values);
    CHECK(total(values, wall) == Approx(2).epsilon(1e-5));
  }
}

TEST_CASE(
    "smoothing is over three panels, near bends over a quarter of their radius, and one panel") {
  const Wall circle(body::circle({}, radius), 300), foil(body::naca0012({}, 1, 0.005, 0), 600);
  for (std::size_t i = 0; i < 300; ++i)
    CHECK(AlongWall(circle).smoothed_over(i) == Approx(3 * circle.panel_length(0)));
  const AlongWall along(foil);
  double longest = 0;
  for (std::size_t i = 0; i < 600; ++i) {
    const double b = foil.panel_length(i), after = foil.panel_length((i + 1) % 600);
    const double bend = std::abs(foil.shape().nearest(foil.middle(i)).curvature);
    const double w = along.smoothed_over(i), next = along.smoothed_over((i + 1) % 600);
    CHECK((w == b || w < 0.2500001 / bend));
    CHECK(std::abs(w - next) < 0.2500001 * (b + after) / 2);
    CHECK(w < 3.0000001 * b);
    longest = std::max(longest, w / b);
  }
  CHECK(longest == Approx(3));
}

namespace {

/// Vorticity around a circle of radius 1, a unit of it in all, spreads from a ring at 1 + y without
/// flux through the circle: how much of it there is at the circle, times nu, makes up what the mean
/// distance grows by. Crank and Nicolson in r, a twin to the closed form.
double at_circle(double y, double nu_t) {
  constexpr int cells = 2000, steps = 800;
  const double h = (y + 8 * std::sqrt(nu_t)) / cells, dt = nu_t / steps;
  std::vector<double> u(cells), diagonal(cells), right(cells);
  const auto edge = [&](int k) { return 1 + h * k; };
  const auto middle = [&](int k) { return 1 + h * (k + 0.5); };
  // Starts from a ring that has spread a twentieth of the time as on a line.
  const double s2 = 4 * nu_t / 20;
  double all = 0;
  for (int k = 0; k < cells; ++k) {
    const double d = middle(k) - 1 - y, image = middle(k) - 1 + y;
    u[k] = std::exp(-d * d / s2) + std::exp(-image * image / s2);
    all += u[k] * h * middle(k);
  }
  for (double& a : u) a /= all;
  const double left = 0.95 * dt / (2 * h * h);
  for (int step = 0; step < steps; ++step) {
    const auto in = [&](int k) { return k > 0 ? left * edge(k) / middle(k) : 0; };
    const auto out = [&](int k) { return k + 1 < cells ? left * edge(k + 1) / middle(k) : 0; };
    for (int k = 0; k < cells; ++k) {
      const double inner = k > 0 ? u[k - 1] : 0, outer = k + 1 < cells ? u[k + 1] : 0;
      right[k] = u[k] + in(k) * (inner - u[k]) + out(k) * (outer - u[k]);
    }
    diagonal[0] = 1 + in(0) + out(0);
    for (int k = 1; k < cells; ++k) {
      const double factor = in(k) / diagonal[k - 1];
      diagonal[k] = 1 + in(k) + out(k) - factor * out(k - 1);
      right[k] += factor * right[k - 1];
    }
    u[cells - 1] = right[cells - 1] / diagonal[cells - 1];
    for (int k = cells - 2; k >= 0; --k) u[k] = (right[k] + out(k) * u[k + 1]) / diagonal[k];
  }
  return 1.5 * u[0] - 0.5 * u[1];
}

}  // namespace

TEST_CASE("a trace's amount is that of heat at a bent wall, to the square of its bend") {
  for (double q : {0.0, 0.5, 1.0, 1.8}) {
    for (double s : {0.05, 0.1}) {
      const CoreAtWall core{1, {0, q * s, {0, 1}, 1}, s, s};
      const double flat = 2 / (std::sqrt(pi) * s) * std::exp(-q * q);
      INFO("q " << q << ", s " << s);
      CHECK(std::abs(trace(core).amount / at_circle(q * s, s * s / 4) - 1) < s * s + 1e-3);
      CHECK(std::abs(flat / at_circle(q * s, s * s / 4) - 1) > 0.3 * s);
    }
  }
}
