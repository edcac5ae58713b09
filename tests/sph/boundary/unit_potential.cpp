#include "sph/boundary/unit_potential.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "body/outlines/shape_group.hpp"
#include "body/shapes/circle.hpp"
#include "body/shapes/ellipse.hpp"

using namespace vortree;
using namespace vortree::sph;
using Complex = std::complex<double>;

namespace {

constexpr double pi = std::numbers::pi;
constexpr auto axes = {UnitPotentials::along_x, UnitPotentials::along_y};

/// d phi/dx - i d phi/dy of a circle around the origin, phi = -a^2 x/r^2 or -a^2 y/r^2.
Complex of_circle(double a, UnitPotentials::Axis axis, Complex z) {
  const Complex slope = a * a / (z * z);
  return axis == UnitPotentials::along_x ? slope : Complex(0, 1) * slope;
}

/// The same of an ellipse of half axes a along x, b along y, as the flow in its plane is that
/// around a circle of radius (a + b)/2: z = zeta + (a^2 - b^2)/(4 zeta).
Complex of_ellipse(double a, double b, UnitPotentials::Axis axis, Complex z) {
  const double focus2 = a * a - b * b, radius = (a + b) / 2;
  Complex root = std::sqrt(z * z - focus2);
  if (std::real(root * std::conj(z)) < 0) root = -root;
  const Complex zeta = 0.5 * (z + root), dz = 1.0 - focus2 / (4.0 * zeta * zeta);
  // phi = Re(stream + uniform flow): -(R^2/zeta - c/zeta) along x, with the body at rest in a
  // stream less that stream.
  const double c = focus2 / 4, r2 = radius * radius;
  const Complex by_zeta = axis == UnitPotentials::along_x
                              ? (r2 + c - 2 * c) / (zeta * zeta)
                              : Complex(0, 1) * (r2 + c) / (zeta * zeta);
  return by_zeta / dz;
}

/// The largest deviation at places a distance d off the wall, nodes in the middle of sources if
/// it is none.
template <class Exact>
double largest_error(const body::Shape& shape, int sources, double d, Exact exact) {
  const UnitPotentials potentials(shape, sources);
  std::vector<double> x, y;
  for (int k = 0; k < 50; ++k) {
    const int source = d > 0 ? k : (k * sources) / 50;
    const double arc =
        d > 0 ? shape.perimeter() * k / 50 : shape.perimeter() * (source + 0.5) / sources;
    const Vec2 wall = shape.point(arc), n = shape.nearest(wall).normal;
    x.push_back(wall.x + d * n.x), y.push_back(wall.y + d * n.y);
  }
  double worst = 0;
  for (const auto axis : axes) {
    std::vector<double> phi_x(x.size()), phi_y(x.size());
    potentials.gradient(axis, {x, y}, phi_x, phi_y);
    for (std::size_t k = 0; k < x.size(); ++k) {
      const Complex found(phi_x[k], -phi_y[k]), known = exact(axis, Complex(x[k], y[k]));
      worst = std::max(worst, std::abs(found - known));
    }
  }
  return worst;
}

}  // namespace

TEST_CASE("Unit potentials of a circle are dipoles") {
  const auto shape = body::circle({}, 0.5);
  const auto exact = [](auto axis, Complex z) { return of_circle(0.5, axis, z); };
  // Sums err by 1e-6 of slopes of 1.
  CHECK(largest_error(*shape, 63, 0.3, exact) < 5e-6);
  for (const auto axis : axes) {
    const Vec2 dipole = UnitPotentials(*shape, 21).dipole(axis);
    const Vec2 known = axis == UnitPotentials::along_x ? Vec2{pi / 2, 0} : Vec2{0, pi / 2};
    CHECK(dipole.x == Approx(known.x).margin(1e-12));
    CHECK(dipole.y == Approx(known.y).margin(1e-12));
  }
}

TEST_CASE("Unit potentials of an ellipse are those of its conformal map") {
  const double a = 0.5, b = 0.2;
  const auto shape = body::ellipse({}, a, b, 0);
  const auto exact = [&](auto axis, Complex z) { return of_ellipse(a, b, axis, z); };
  CHECK(largest_error(*shape, 201, 0.1, exact) < 1e-5);
  // Added mass of an ellipse: pi b^2 along a, pi a^2 along b (Lamb, Hydrodynamics, section 71), and
  // with the area pi a b the dipole pi b (a + b), pi a (a + b).
  const UnitPotentials potentials(*shape, 201);
  CHECK(potentials.dipole(UnitPotentials::along_x).x == Approx(pi * b * (a + b)).epsilon(1e-10));
  CHECK(potentials.dipole(UnitPotentials::along_y).y == Approx(pi * a * (a + b)).epsilon(1e-10));
}

TEST_CASE("Near the wall unit potentials err as the trapezoidal rule does, exp(-2 pi d/step)") {
  const auto shape = body::circle({}, 0.5);
  const auto exact = [](auto axis, Complex z) { return of_circle(0.5, axis, z); };
  const int sources = 101;
  const double step = pi / sources;
  for (const double steps : {0.5, 1.0, 1.5}) {
    const double error = largest_error(*shape, sources, steps * step, exact);
    CHECK(error < 4 * std::exp(-2 * pi * steps));
    CHECK(error > 0.05 * std::exp(-2 * pi * steps));
  }
}

TEST_CASE("In the middle between two sources the slope along the wall is exact") {
  const double a = 0.5, b = 0.2;
  const auto circle = body::circle({}, a), ellipse = body::ellipse({}, a, b, 0);
  const auto along_wall = [](const body::Shape& shape, int sources, auto exact) {
    const UnitPotentials potentials(shape, sources);
    double worst = 0;
    for (int k = 0; k < sources; ++k) {
      const Vec2 at = shape.point(shape.perimeter() * (k + 0.5) / sources);
      const Vec2 t = shape.nearest(at).tangent();
      for (const auto axis : axes) {
        double x[1] = {at.x}, y[1] = {at.y}, phi_x[1], phi_y[1];
        potentials.gradient(axis, {x, y}, phi_x, phi_y);
        const Complex known = exact(axis, Complex(at.x, at.y));
        worst = std::max(worst, std::abs(phi_x[0] * t.x + phi_y[0] * t.y - known.real() * t.x +
                                         known.imag() * t.y));
      }
    }
    return worst;
  };
  CHECK(along_wall(*circle, 63, [&](auto axis, Complex z) { return of_circle(a, axis, z); }) <
        1e-5);
  CHECK(along_wall(*ellipse, 201, [&](auto axis, Complex z) { return of_ellipse(a, b, axis, z); }) <
        1e-5);
}

namespace {

/// A dipole mu/(z - at)^2 and its images in two circles in turn, by Milne-Thomson's circle theorem,
/// the first in the circle that it does not stand in.
struct DipoleImages {
  std::vector<std::pair<Complex, Complex>> all;

  /// The circle of number k alone moves along x, or y.
  DipoleImages(const std::array<Complex, 2>& centre, const std::array<double, 2>& radius, int k,
               UnitPotentials::Axis axis) {
    Complex at = centre[k], mu = of_circle(radius[k], axis, 1);
    for (int n = 0; n < 40; ++n) {
      all.emplace_back(at, mu);
      k = 1 - k;
      const Complex away = std::conj(at - centre[k]) / radius[k];
      mu = -std::conj(mu) / (away * away);
      at = centre[k] + radius[k] / away;
    }
  }

  Complex slope(Complex z) const {
    Complex sum = 0;
    for (const auto& [at, mu] : all) sum += mu / ((z - at) * (z - at));
    return sum;
  }
  Complex dipole() const {
    Complex sum = 0;
    for (const auto& [at, mu] : all) sum += 2 * pi * mu;
    return sum;
  }
};

}  // namespace

TEST_CASE("one of two circles that moves makes the potential that its images make") {
  const std::array<Complex, 2> centre{Complex{0, 0}, {1.1, 0.6}};
  const std::array<double, 2> radius{0.5, 0.3};
  const body::ShapeGroup group(
      {body::circle({}, radius[0]),
       std::make_shared<body::PlacedShape>(body::circle({}, radius[1]), Vec2{1.1, 0.6})});
  const UnitPotentials potentials(group, {160, 96});
  std::vector<double> x, y;
  for (int k = 0; k < 40; ++k)
    for (const int of : {0, 1}) {
      // Off the walls by 0.14, seven steps: the trapezoidal rule errs by exp(-14 pi).
      const Complex at = centre[of] + std::polar(radius[of] + 0.14, 2 * pi * k / 40);
      x.push_back(at.real()), y.push_back(at.imag());
    }
  for (const std::size_t body : {0, 1})
    for (const auto axis : axes) {
      CAPTURE(body, static_cast<int>(axis));
      const DipoleImages exact(centre, radius, static_cast<int>(body), axis);
      std::vector<double> phi_x(x.size()), phi_y(x.size());
      potentials.gradient(axis, {x, y}, phi_x, phi_y, body);
      double worst = 0;
      for (std::size_t k = 0; k < x.size(); ++k)
        worst = std::max(worst, std::abs(Complex(phi_x[k], -phi_y[k]) - exact.slope({x[k], y[k]})));
      CHECK(worst < 3e-6);  // of the sums, 1e-6
      const Vec2 dipole = potentials.dipole(axis, body);
      CHECK(std::abs(Complex(dipole.x, dipole.y) - exact.dipole()) < 1e-9);
    }
}
