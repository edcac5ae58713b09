#include "body/shapes/joukowski.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <string>

#include "base/rounded.hpp"
#include "body/outlines/outline.hpp"
#include "body/shapes/shapes.hpp"
#include "tree/base/told.hpp"

namespace vortree::body {
namespace {

using std::numbers::pi;
using MapPlace = std::complex<double>;

/// The circle before it is mapped; by an angle from its edge on.
struct MappedCircle {
  double e, h, g;

  double radius() const { return std::hypot(1 + e, h) + g; }
  MapPlace zeta(double t) const {
    return MapPlace{-e, h} + radius() * std::polar(1.0, t + std::atan2(-h, 1 + e));
  }
  MapPlace z(double t) const {
    const MapPlace at = zeta(t);
    return at + 1.0 / at;
  }
  CurvePoint at(double t) const {
    const MapPlace one = zeta(t), from = one - MapPlace{-e, h}, slope = 1.0 - 1.0 / (one * one);
    const MapPlace first = MapPlace{0, 1} * from * slope,
                   second = -from * slope - 2.0 * from * from / (one * one * one),
                   place = one + 1.0 / one;
    return {
        {place.real(), place.imag()}, {first.real(), first.imag()}, {second.real(), second.imag()}};
  }
};

/// Where a function that rises from low to high does so through 0.
template <class Function>
double root(double low, double high, const Function& function) {
  for (int k = 0; k < 60; ++k) {
    const double middle = (low + high) / 2;
    (function(middle) < 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// Of the section without camber, from its nose to its edge.
double chord_of(double e, double g) {
  const double nose = 1 + 2 * e + g, edge = 1 + g;
  return nose + 1 / nose + edge + 1 / edge;
}

/// Of the curvature at zeta = 1 + g, in chords.
double edge_of(double e, double g) {
  const double zeta = 1 + g, a = 1 + e + g, slope = g * (2 + g) / (zeta * zeta);
  return a * slope * slope / (slope + 2 * a / (zeta * zeta * zeta)) / chord_of(e, g);
}

/// In chords: where y is greatest dy/dt = 0.
double thickness_of(double e, double g) {
  const MappedCircle circle{e, 0, g};
  const double t = root(1e-3, pi - 1e-3, [&](double at) { return -circle.at(at).first.y; });
  return 2 * circle.z(t).imag() / chord_of(e, g);
}

/// The g that leaves such an edge.
double gap_for(double edge, double e) {
  return root(0, 2, [&](double g) { return edge_of(e, g) - edge; });
}

MappedCircle circle_for(double thickness, double camber, double edge) {
  const double e =
      root(0, 2, [&](double of) { return thickness_of(of, gap_for(edge, of)) - thickness; });
  return {e, 2 * camber, gap_for(edge, e)};
}

/// Where x is least, or greatest, around the nose and around the edge: dx/dt = 0.
double end_of(const MappedCircle& circle, double around) {
  const double way = around == 0 ? -1 : 1;
  const double t =
      root(around - 1, around + 1, [&](double at) { return way * circle.at(at).first.x; });
  return circle.z(t).real();
}

double length(const BodySettings& body) {
  return body.number("chord");
}

std::unique_ptr<Shape> draw(const BodySettings& body) {
  return joukowski({}, body.number("chord"), body.number("thickness"), body.number("camber"),
                   body.number("edge"), body.turn());
}

void hold(const BodySettings& body) {
  const double chord = body.number("chord"), thickness = body.number("thickness"),
               camber = body.number("camber");
  const double least = chord * thinnest_joukowski(body.number("edge"));
  if (!(thickness >= least && thickness <= chord / 2))
    throw Refused("body.thickness", "body.thickness is " + rounded(thickness, 6) + "; " +
                                        rounded_up(least, 4) + " .. " + rounded(chord / 2, 4) +
                                        " was expected, with such a chord and edge");
  if (!(camber >= 0 && camber <= chord / 4))
    throw Refused("body.camber", "body.camber is " + rounded(camber, 6) + "; 0 .. " +
                                     rounded(chord / 4, 4) + " was expected, with such a chord");
}

constexpr Rule edges{.low = 1e-4, .high = 0.02, .words = "it must lie in 1e-4 .. 0.02"};

}  // namespace

const ShapeKind& joukowski_kind() {
  static const ShapeKind kind{
      {"joukowski",
       {{"chord", positive, "L", "its length"},
        {"thickness", positive, "L", "the largest, without camber"},
        {"camber", not_negative, "L", "height of the arc that it is bent along", 0},
        {"edge", edges, "chord", "radius of the trailing edge, which has a cusp without", 0.002}}},
      length,
      draw,
      "",
      hold};
  return kind;
}

double thinnest_joukowski(double edge) {
  return thickness_of(0, gap_for(edge, 0));
}

std::unique_ptr<Shape> joukowski(Vec2 centre, double chord, double thickness, double camber,
                                 double edge, double incidence) {
  if (!(chord > 0 && edge >= 1e-4 && edge <= 0.02 && camber >= 0 && camber <= chord / 4 &&
        thickness >= chord * thinnest_joukowski(edge) && thickness <= chord / 2))
    throw std::invalid_argument("section of chord " + tree::told(chord) + ", thickness " +
                                tree::told(thickness) + ", camber " + tree::told(camber) +
                                ", edge " + tree::told(edge) + " is no section of Joukowski");
  const MappedCircle circle = circle_for(thickness / chord, camber / chord, edge);
  const double nose = end_of(circle, pi), tail = end_of(circle, 0), scale = chord / (tail - nose);
  const Vec2 middle{(nose + tail) / 2, 0};
  return outline([&, place = Placement(centre, incidence)](double t) {
    const CurvePoint c = circle.at(t);
    return place({scale * (c.at - middle), scale * c.first, scale * c.second});
  });
}

}  // namespace vortree::body
