#include "body/shapes/naca4.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "body/outlines/outline.hpp"
#include "body/shapes/from_points/crossing.hpp"
#include "body/shapes/jet.hpp"
#include "body/shapes/shapes.hpp"
#include "tree/base/told.hpp"

namespace vortree::body {
namespace {

struct Section {
  double camber, at, thickness;
};

/// What is wrong with digits, or nothing.
std::string objection(std::string_view digits) {
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  if (digits.size() != 4 || !std::ranges::all_of(digits, digit))
    return "four digits were expected, as \"2412\"";
  if (digits.substr(2) == "00") return "the last two are its thickness; 01 .. 99 was expected";
  if (digits[0] != '0' && digits[1] == '0')
    return "it has camber; the second digit, where that is, must be 1 .. 9";
  return "";
}

Section section_of(std::string_view digits) {
  const auto digit = [&](int k) { return digits[k] - '0'; };
  return {digit(0) / 100.0, digit(1) / 10.0, (10 * digit(2) + digit(3)) / 100.0};
}

/// Half the thickness of the section by r = sqrt(x), not yet rounded.
Jet half_thickness(double r, double thickness, double edge) {
  const double t = 5 * thickness;
  const std::array<double, 9> c{0,          t * 0.2969, -t * 0.1260,      0, -t * 0.3516, 0,
                                t * 0.2843, 0,          edge - t * 0.1036};
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

/// The mean line and its slope, by x.
struct MeanLine {
  Jet y, slope;
};

MeanLine mean_line(const Section& of, double x) {
  if (of.camber == 0) return {};
  const double p = of.at, back = 1 - p;
  const double steep = of.camber / (x < p ? p * p : back * back), start = x < p ? 0 : 1 - 2 * p;
  return {{steep * (start + 2 * p * x - x * x), 2 * steep * (p - x), -2 * steep},
          {2 * steep * (p - x), -2 * steep, 0}};
}

/// cos theta by tan theta.
Jet cosine(double slope) {
  const double root = std::sqrt(1 + slope * slope), cube = root * root * root;
  return {1 / root, -slope / cube, (2 * slope * slope - 1) / (cube * root * root)};
}

CurvePoint place_on(const Section& of, double edge, double t) {
  // r = sqrt(x) is the size of cos(t/2), and goes from the upper to the lower side with its sign.
  const double c = std::cos(t / 2), s = std::sin(t / 2), side = c < 0 ? -1 : 1;
  const Jet r{side * c, -side * s / 2, -side * c / 4}, root{s, c / 2, -s / 4};
  const Jet x = r * r;
  const Jet half = side * (composed(half_thickness(r.value, of.thickness, edge), r) *
                           composed(rounding(s, edge / 2), root));
  const MeanLine line = mean_line(of, x.value);
  const Jet slope = composed(line.slope, x), along = composed(cosine(slope.value), slope);
  const Jet px = x - half * (along * slope), py = composed(line.y, x) + half * along;
  return {{px.value - 0.5, py.value}, {px.first, py.first}, {px.second, py.second}};
}

double length(const BodySettings& body) {
  return body.number("chord");
}

std::unique_ptr<Shape> draw(const BodySettings& body) {
  return naca4({}, body.digits.value_or(""), body.number("chord"), body.number("edge"),
               body.turn());
}

void hold(const BodySettings& body) {
  const std::string is = "body.digits is \"" + *body.digits + "\"; ";
  if (const std::string wrong = objection(*body.digits); !wrong.empty())
    throw Refused("body.digits", is + wrong);
  if (folds(*draw(body)))
    throw Refused("body.digits", is + "so much camber so near to an end folds the outline of so "
                                      "thick a section; less of one of them was expected");
}

constexpr Rule edges{.low = 1e-4, .high = 0.02, .words = "it must lie in 1e-4 .. 0.02"};

}  // namespace

const ShapeKind& naca4_kind() {
  static const ShapeKind kind{{"naca4",
                               {{"chord", positive, "L", "its length"},
                                {"edge", edges, "chord", "radius of the trailing edge", 0.005}}},
                              length,
                              draw,
                              "digits",
                              hold};
  return kind;
}

std::unique_ptr<Shape> naca4(Vec2 centre, std::string_view digits, double chord, double edge,
                             double incidence) {
  if (const std::string wrong = objection(digits); !wrong.empty())
    throw std::invalid_argument("NACA \"" + std::string(digits) + "\": " + wrong);
  if (!(chord > 0 && std::isfinite(chord)))
    throw std::invalid_argument("chord is " + tree::told(chord) + "; must be > 0");
  if (!(edge >= 1e-4 && edge <= 0.02))
    throw std::invalid_argument("trailing edge of radius " + tree::told(edge) +
                                " of the chord; must be in 1e-4 .. 0.02");
  const Section of = section_of(digits);
  const Placement place(centre, incidence);
  const auto curve = [&](double t) {
    const CurvePoint c = place_on(of, edge, t);
    return place({chord * c.at, chord * c.first, chord * c.second});
  };
  if (of.camber == 0) return outline(curve);
  const double crest = 2 * std::acos(std::sqrt(of.at));
  return outline(curve, {crest, 2 * std::numbers::pi - crest});
}

}  // namespace vortree::body
