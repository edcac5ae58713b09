#include "body/shapes/naca0012.hpp"

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "body/outline.hpp"
#include "body/shapes/shapes.hpp"
#include "tree/base/told.hpp"

namespace vortree::body {
namespace {

/// A function of one variable and its first two derivatives.
struct Jet {
  double value, first, second;

  friend Jet operator*(const Jet& a, const Jet& b) {
    return {a.value * b.value, a.first * b.value + a.value * b.first,
            a.second * b.value + 2 * a.first * b.first + a.value * b.second};
  }
};

/// Half the thickness of the section by r = sqrt(x), not yet rounded.
Jet half_thickness(double r, double edge) {
  const std::array<double, 9> c{
      0, 0.6 * 0.2969, -0.6 * 0.1260, 0, -0.6 * 0.3516, 0, 0.6 * 0.2843, 0, edge - 0.6 * 0.1036};
  Jet sum{};
  for (int k = 8; k >= 0; --k) {
    sum.second = sum.second * r + 2 * sum.first;
    sum.first = sum.first * r + sum.value;
    sum.value = sum.value * r + c[k];
  }
  return sum;
}

/// sqrt((1 - x)/(1 - x + k)) by s = sqrt(1 - x), odd in s.
Jet rounding(double s, double k) {
  const double root = std::sqrt(s * s + k), cube = root * root * root;
  return {s / root, k / cube, -3 * k * s / (cube * root * root)};
}

/// f(g(t)).
Jet composed(const Jet& f, const Jet& g) {
  return {f.value, f.first * g.first, f.second * g.first * g.first + f.first * g.second};
}

double length(const BodySettings& body) {
  return body.number("chord");
}

std::unique_ptr<Shape> draw(const BodySettings& body) {
  return naca0012({}, body.number("chord"), body.number("edge"), body.turn());
}

constexpr Rule edges{.low = 1e-4, .high = 0.02, .words = "it must lie in 1e-4 .. 0.02"};

}  // namespace

const ShapeKind& naca0012_kind() {
  static const ShapeKind kind{{"naca0012",
                               {{"chord", positive, "L", "its length"},
                                {"edge", edges, "chord", "radius of the trailing edge", 0.005}}},
                              length,
                              draw};
  return kind;
}

std::unique_ptr<Shape> naca0012(Vec2 centre, double chord, double edge, double incidence) {
  if (!(chord > 0 && std::isfinite(chord)))
    throw std::invalid_argument("chord is " + tree::told(chord) + "; must be > 0");
  if (!(edge >= 1e-4 && edge <= 0.02))
    throw std::invalid_argument("trailing edge of radius " + tree::told(edge) +
                                " of the chord; must be in 1e-4 .. 0.02");
  return outline([=, place = Placement(centre, incidence)](double t) {
    // r = sqrt(x) is the size of cos(t/2), and goes from the upper to the lower side with its sign.
    const double c = std::cos(t / 2), s = std::sin(t / 2), side = c < 0 ? -1 : 1;
    const Jet r{side * c, -side * s / 2, -side * c / 4}, root{s, c / 2, -s / 4};
    const Jet x = r * r;
    const Jet y =
        composed(half_thickness(r.value, edge), r) * composed(rounding(s, edge / 2), root);
    return place({chord * Vec2{x.value - 0.5, side * y.value},
                  chord * Vec2{x.first, side * y.first}, chord * Vec2{x.second, side * y.second}});
  });
}

}  // namespace vortree::body
