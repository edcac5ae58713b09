#include "body/shapes/from_points/contour.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/rounded.hpp"
#include "body/shapes/from_points/crossing.hpp"

namespace vortree::body {
namespace {

constexpr std::size_t fewest = 8, most = 1000;
constexpr double sharp = 80, blunt = 45;  // degrees

double size(Vec2 a) {
  return std::sqrt(dot(a, a));
}

double cross(Vec2 a, Vec2 b) {
  return a.x * b.y - a.y * b.x;
}

std::string said(double value) {
  return rounded(value, 4);
}

std::string said(Vec2 at) {
  return "(" + rounded(at.x, 6) + ", " + rounded(at.y, 6) + ")";
}

std::vector<Vec2> read(std::span<const double> coordinates) {
  if (coordinates.size() % 2 != 0)
    throw BadPoint(coordinates.size() / 2, "there is an x without a y");
  std::vector<Vec2> all;
  for (std::size_t i = 0; i < coordinates.size() / 2; ++i) {
    const Vec2 at{coordinates[2 * i], coordinates[2 * i + 1]};
    if (!std::isfinite(at.x) || !std::isfinite(at.y))
      throw BadPoint(i, "the point is " + said(at) + "; finite numbers were expected");
    all.push_back(at);
  }
  return all;
}

double farthest_from(const std::vector<Vec2>& places, Vec2 at) {
  double farthest = 0;
  for (const Vec2 place : places) farthest = std::max(farthest, size(place - at));
  return farthest;
}

/// Nearer than what round-off makes of the same place, in shares of the size of all.
constexpr double same = 1e-9;

void hold_apart(const std::vector<Vec2>& points) {
  const double least = same * farthest_from(points, points.front());
  for (std::size_t i = 1; i < points.size(); ++i)
    if (size(points[i] - points[i - 1]) <= least)
      throw BadPoint(i, "the point " + said(points[i]) + " is the same as the one before");
}

void hold_count(const std::vector<Vec2>& points) {
  const std::string count = std::to_string(points.size());
  if (points.size() < fewest)
    throw BadPoint(0, "there are " + count + " points; an outline has 8 at least");
  if (points.size() > most)
    throw BadPoint(most, "there are " + count + " points; an outline has 1000 at most");
}

/// Twice the area; negative of a clockwise one.
double area(const std::vector<Vec2>& polygon) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    sum += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  return sum;
}

/// How much a closed polygon turns at a place [degrees].
double corner(const std::vector<Vec2>& polygon, std::size_t i) {
  const std::size_t n = polygon.size();
  const Vec2 a = polygon[i] - polygon[(i + n - 1) % n], b = polygon[(i + 1) % n] - polygon[i];
  return std::abs(std::atan2(cross(a, b), dot(a, b))) * 180 / std::numbers::pi;
}

Edge edge_of(const std::vector<Vec2>& places, bool closed) {
  const double first = corner(places, 0), last = corner(places, places.size() - 1);
  if (!closed && first > blunt && last > blunt) return Edge::blunt;
  return first > sharp ? Edge::sharp : Edge::none;
}

void hold_corners(const std::vector<Vec2>& places, Edge edge) {
  const std::size_t end = places.size() - (edge == Edge::blunt ? 1 : 0);
  for (std::size_t i = edge == Edge::none ? 0 : 1; i < end; ++i)
    if (const double turns = corner(places, i); turns > sharp)
      throw BadPoint(i, "the outline turns by " + said(turns) + " degrees at " + said(places[i]) +
                            ", a corner; only its first point may be one, a trailing edge. More "
                            "points around it round it");
}

/// The longer of the sides beside the one that closes it.
double beside_the_last(const std::vector<Vec2>& places) {
  const std::size_t n = places.size();
  return std::max(size(places[1] - places[0]), size(places[n - 1] - places[n - 2]));
}

void hold_closed(const std::vector<Vec2>& places, Edge edge) {
  const double gap = size(places.back() - places.front());
  const double widest =
      edge == Edge::blunt ? farthest_from(places, places[0]) / 10 : 4 * beside_the_last(places);
  if (gap > widest)
    throw BadPoint(places.size() - 1, "the outline is open: its last point " + said(places.back()) +
                                          " and its first " + said(places.front()) + " are " +
                                          said(gap) + " apart, more than " + said(widest));
}

/// The point that is the place of that number.
std::size_t point_of(const Contour& contour, std::size_t place) {
  if (!contour.clockwise || (place == 0 && contour.edge != Edge::blunt)) return place;
  return contour.places.size() - place - (contour.edge == Edge::blunt ? 1 : 0);
}

}  // namespace

double Contour::gap() const {
  return edge == Edge::blunt ? size(places.back() - places.front()) : 0;
}

Contour contour_of(std::span<const double> coordinates) {
  std::vector<Vec2> places = read(coordinates);
  hold_count(places);
  hold_apart(places);
  const bool closed =
      size(places.back() - places.front()) <= same * farthest_from(places, places.front());
  if (closed) places.pop_back();
  const Edge edge = edge_of(places, closed);
  hold_corners(places, edge);
  hold_closed(places, edge);
  const bool clockwise = area(places) < 0;
  if (clockwise) std::reverse(places.begin() + (edge == Edge::blunt ? 0 : 1), places.end());
  return {std::move(places), clockwise, edge};
}

void hold_points(std::span<const double> coordinates) {
  const Contour contour = contour_of(coordinates);
  if (const auto crossing = crossing_of(contour.places)) {
    const auto [i, k] = *crossing;
    const std::size_t a = point_of(contour, i), b = point_of(contour, k);
    throw BadPoint(std::max(a, b), "the outline crosses itself: its sides at " +
                                       said(contour.places[i]) + " and " + said(contour.places[k]) +
                                       " meet");
  }
}

}  // namespace vortree::body
