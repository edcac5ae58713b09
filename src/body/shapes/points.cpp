#include "body/shapes/points.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/rounded.hpp"
#include "body/outlines/chain.hpp"
#include "body/shapes/from_points/contour.hpp"
#include "body/shapes/from_points/crossing.hpp"
#include "body/shapes/from_points/spline.hpp"
#include "body/shapes/from_points/trailing_edge.hpp"
#include "body/shapes/shapes.hpp"

namespace vortree::body {
namespace {

constexpr double shown = 4;  // digits

double angle_between(Vec2 a, Vec2 b) {
  return std::abs(std::atan2(a.x * b.y - a.y * b.x, dot(a, b)));
}

std::vector<Stretch> stretches_of(const Spline& spline) {
  std::vector<Stretch> all;
  for (std::size_t i = 0; i < spline.stretches(); ++i) {
    const double from = spline.knot(i), chord = spline.knot(i + 1) - from;
    const auto at = [&spline, i, from, chord](double share) {
      const CurvePoint c = spline.at(i, from + share * chord);
      return CurvePoint{c.at, chord * c.first, (chord * chord) * c.second};
    };
    all.push_back({at, chord, angle_between(at(0).first, at(1).first)});
  }
  return all;
}

Vec2 middle_of(const Contour& contour) {
  if (contour.edge != Edge::none) {
    const Chord chord = chord_of(contour);
    return 0.5 * (chord.nose + chord.tail);
  }
  const auto [left, right] = std::ranges::minmax(contour.places, {}, &Vec2::x);
  const auto [low, high] = std::ranges::minmax(contour.places, {}, &Vec2::y);
  return {(left.x + right.x) / 2, (low.y + high.y) / 2};
}

std::vector<double> scaled(const BodySettings& body) {
  std::vector<double> all = *body.points;
  for (double& one : all) one *= body.number("scale");
  return all;
}

/// Along x, as the points are written.
double length(const BodySettings& body) {
  double low = INFINITY, high = -INFINITY;
  for (std::size_t i = 0; i + 1 < body.points->size(); i += 2) {
    low = std::min(low, (*body.points)[i]);
    high = std::max(high, (*body.points)[i]);
  }
  return body.number("scale") * (high - low);
}

std::unique_ptr<Shape> draw(const BodySettings& body) {
  return through_points(scaled(body), body.number("edge"), body.turn());
}

void hold(const BodySettings& body) {
  const auto words = [](const std::string& of) { return "body.points: " + of; };
  try {
    hold_points(*body.points);
    if (folds(*draw(body)))
      throw BadPoint(0,
                     "the curve through them folds or crosses itself, though they do not: more "
                     "of them, or another edge, were expected");
    const auto edge = body.numbers.find("edge");
    if (edge != body.numbers.end() && edge->second && contour_of(*body.points).edge == Edge::none)
      throw Refused("body.edge",
                    "body.edge is " + rounded(*edge->second, 6) +
                        "; the points have no trailing edge to be rounded: their first "
                        "is no corner");
  } catch (const BadPoint& bad) {
    throw Refused("body.points",
                  words("point " + std::to_string(bad.point + 1) + ": " + bad.what()));
  }
}

std::string said(double value) {
  return rounded(value, shown);
}

/// Where the points come from.
std::string name_of(const BodySettings& body) {
  return body.file ? "body.file = \"" + *body.file + "\"" : "body.points";
}

std::vector<std::string> told(const BodySettings& body) {
  const Contour contour = contour_of(*body.points);
  std::vector<std::string> list;
  if (contour.clockwise)
    list.push_back(name_of(body) +
                   ": the outline runs clockwise, and is taken the other way round");
  if (contour.edge == Edge::none) return list;
  const double edge = body.number("edge"), radius = radius_of_edge(contour, edge),
               gap = contour.gap() / chord_of(contour).length();
  list.push_back(name_of(body) + ": the trailing edge, " +
                 (gap > 0 ? "open by " + said(gap) + " of the chord" : std::string("sharp")) +
                 ", is closed and rounded with a radius of " + said(radius) + " of it" +
                 (radius > edge ? ", half of what it is open" : "") +
                 ", for which the section gets up to " + said(2 * radius - gap) +
                 " thicker towards it");
  return list;
}

constexpr Rule edges{.low = 1e-4, .high = 0.02, .words = "it must lie in 1e-4 .. 0.02"};

}  // namespace

const ShapeKind& points_kind() {
  static const ShapeKind kind{
      {"points",
       {{"edge", edges, "chord", "radius of the trailing edge, if the first point is one", 0.005},
        {"scale", positive, "",
         "what its coordinates are multiplied by; its length is then their "
         "extent along x",
         1}}},
      length,
      draw,
      "points",
      hold,
      told};
  return kind;
}

std::unique_ptr<Shape> through_points(std::span<const double> coordinates, double edge,
                                      double incidence) {
  const Contour contour = contour_of(coordinates);
  std::vector<Vec2> places =
      contour.edge == Edge::none ? contour.places : rounded_behind(contour, edge);
  const Vec2 middle = middle_of(contour);
  for (Vec2& place : places) place = place - middle;
  const Spline spline = Spline::closed(places);
  return chained(stretches_of(spline), Placement({}, incidence));
}

}  // namespace vortree::body
