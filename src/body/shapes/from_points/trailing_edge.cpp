#include "body/shapes/from_points/trailing_edge.hpp"

#include <algorithm>
#include <cmath>

#include "body/shapes/from_points/spline.hpp"

namespace vortree::body {
namespace {

double size(Vec2 a) {
  return std::sqrt(dot(a, a));
}

/// Coordinates along a chord and across it, in chords, from the nose on.
class ChordAxes {
 public:
  explicit ChordAxes(const Chord& chord)
      : nose_(chord.nose), along_(chord.tail - chord.nose), across_{-along_.y, along_.x} {}

  Vec2 seen(Vec2 at) const {
    const double square = dot(along_, along_);
    return {dot(at - nose_, along_) / square, dot(at - nose_, across_) / square};
  }
  Vec2 place(Vec2 seen) const { return nose_ + seen.x * along_ + seen.y * across_; }

 private:
  Vec2 nose_, along_, across_;
};

/// The section from edge to edge: a sharp one has its first place twice.
std::vector<Vec2> from_edge_to_edge(const Contour& contour) {
  std::vector<Vec2> all = contour.places;
  if (contour.edge == Edge::sharp) all.push_back(all.front());
  return all;
}

/// One side of a section behind the middle of its chord: y by x.
class SideOfSection {
 public:
  /// From the edge on; `last` counts from the end.
  SideOfSection(const Spline& spline, const std::vector<Vec2>& seen, bool last) : spline_(&spline) {
    const std::size_t n = seen.size();
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t i = last ? n - 1 - k : k;
      if (k > 0 && seen[i].x >= seen[last ? i + 1 : i - 1].x)
        throw BadPoint(i,
                       "behind the middle of the chord the outline runs forth and back; a "
                       "trailing edge cannot be rounded there");
      x_.push_back(seen[i].x);
      stretch_.push_back(last && k > 0 ? i : (k > 0 ? i - 1 : 0));
      if (seen[i].x < 0.5) break;
    }
  }

  double y(double x) const {
    const auto k = std::clamp<std::size_t>(
        std::ranges::lower_bound(x_, x, std::greater<>()) - x_.begin(), 1, x_.size() - 1);
    const std::size_t i = stretch_[k];
    double low = spline_->knot(i), high = spline_->knot(i + 1);
    const bool rises = spline_->at(i, high).at.x > spline_->at(i, low).at.x;
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = (low + high) / 2;
      ((spline_->at(i, middle).at.x < x) == rises ? low : high) = middle;
    }
    return spline_->at(i, (low + high) / 2).at.y;
  }

 private:
  const Spline* spline_;
  std::vector<double> x_;             // falling
  std::vector<std::size_t> stretch_;  // that ends or begins at each, towards the edge
};

/// sqrt(1 - x) from 0 on to the middle of the chord: an eighth of a radius apart around the edge.
std::vector<double> roots_behind(double radius) {
  const double last = std::sqrt(0.5);
  std::vector<double> all{0};
  while (all.back() < last)
    all.push_back(all.back() + std::min(0.015, std::sqrt(all.back() * all.back() + radius) / 16));
  for (double& root : all) root *= last / all.back();
  return all;
}

}  // namespace

double Chord::length() const {
  return size(tail - nose);
}

Chord chord_of(const Contour& contour) {
  const std::vector<Vec2>& all = contour.places;
  const Vec2 tail = contour.edge == Edge::blunt ? 0.5 * (all.front() + all.back()) : all.front();
  const auto nose =
      std::ranges::max_element(all, {}, [&](Vec2 at) { return dot(at - tail, at - tail); });
  return {*nose, tail, static_cast<std::size_t>(nose - all.begin())};
}

double radius_of_edge(const Contour& contour, double edge) {
  return std::max(edge, contour.gap() / (2 * chord_of(contour).length()));
}

std::vector<Vec2> rounded_behind(const Contour& contour, double edge) {
  const ChordAxes axes(chord_of(contour));
  std::vector<Vec2> seen = from_edge_to_edge(contour);
  for (Vec2& at : seen) at = axes.seen(at);
  const Spline spline = Spline::open(seen);
  const SideOfSection first(spline, seen, false), last(spline, seen, true);

  const double radius = radius_of_edge(contour, edge),
               more = radius - contour.gap() / (2 * chord_of(contour).length());
  const std::vector<double> roots = roots_behind(radius);
  std::vector<Vec2> one, other;
  for (const double root : roots) {
    const double x = 1 - root * root, a = first.y(x), b = last.y(x), mean = (a + b) / 2;
    const double weight = std::pow(2 * x - 1, 4);
    const double shrunk = root / std::sqrt(root * root + radius / 2);
    const double half = ((a - b) / 2 + more * weight) * (1 + weight * (shrunk - 1));
    one.push_back(axes.place({x, mean + half}));
    other.push_back(axes.place({x, mean - half}));
  }
  // Before the middle places stay, but for one that would stand too close to the new ones.
  const double spacing = 2 * roots.back() * (roots.back() - roots[roots.size() - 2]);
  std::vector<Vec2> all = one;
  for (const Vec2 at : seen)
    if (at.x < 0.5 - spacing / 2) all.push_back(axes.place(at));
  all.insert(all.end(), other.rbegin(), other.rend() - 1);
  return all;
}

}  // namespace vortree::body
