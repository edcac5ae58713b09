#include "body/shapes/from_points/spline.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

namespace vortree::body {
namespace {

/// Rows below[i] x[i - 1] + here[i] x[i] + above[i] x[i + 1] = right[i].
struct Tridiagonal {
  std::vector<double> below, here, above;

  std::vector<Vec2> solved(std::vector<Vec2> right) const {
    std::vector<double> pivot = here;
    const std::size_t n = here.size();
    for (std::size_t i = 1; i < n; ++i) {
      const double share = below[i] / pivot[i - 1];
      pivot[i] -= share * above[i - 1];
      right[i] += -share * right[i - 1];
    }
    right[n - 1] = (1 / pivot[n - 1]) * right[n - 1];
    for (std::size_t i = n - 1; i-- > 0;)
      right[i] = (1 / pivot[i]) * (right[i] - above[i] * right[i + 1]);
    return right;
  }
};

/// The slope at the first of four places of the cubic through values there.
Vec2 first_slope(const std::array<double, 4>& t, const std::array<Vec2, 4>& p) {
  Vec2 slope{};
  for (int i = 1; i < 4; ++i) {
    double weight = 1 / (t[i] - t[0]);
    for (int k = 1; k < 4; ++k)
      if (k != i) weight *= (t[0] - t[k]) / (t[i] - t[k]);
    slope += weight * (p[i] - p[0]);
  }
  return slope;
}

}  // namespace

Spline::Spline(std::span<const Vec2> points) : point_(points.begin(), points.end()) {
  if (points.size() < 4) throw std::invalid_argument("a spline needs four points");
  knot_.push_back(0);
  for (std::size_t i = 1; i < point_.size(); ++i) {
    const Vec2 way = point_[i] - point_[i - 1];
    knot_.push_back(knot_.back() + std::sqrt(dot(way, way)));
  }
}

Spline Spline::open(std::span<const Vec2> points) {
  Spline spline(points);
  spline.solve_open();
  return spline;
}

Spline Spline::closed(std::span<const Vec2> points) {
  std::vector<Vec2> round(points.begin(), points.end());
  round.push_back(points.front());
  Spline spline(round);
  spline.solve_closed();
  return spline;
}

void Spline::solve_open() {
  const std::size_t n = point_.size();
  const auto step = [&](std::size_t i) { return knot_[i + 1] - knot_[i]; };
  const auto chord = [&](std::size_t i) { return (1 / step(i)) * (point_[i + 1] - point_[i]); };
  const auto slope = [&](bool last) {
    std::array<double, 4> t;
    std::array<Vec2, 4> p;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t i = last ? n - 1 - k : k;
      t[k] = knot_[i], p[k] = point_[i];
    }
    return first_slope(t, p);
  };
  Tridiagonal rows{std::vector<double>(n), std::vector<double>(n), std::vector<double>(n)};
  std::vector<Vec2> right(n);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    rows.below[i] = step(i - 1), rows.above[i] = step(i),
    rows.here[i] = 2 * (step(i - 1) + step(i));
    right[i] = 6 * (chord(i) - chord(i - 1));
  }
  rows.here[0] = 2 * step(0), rows.above[0] = step(0), right[0] = 6 * (chord(0) - slope(false));
  rows.here[n - 1] = 2 * step(n - 2), rows.below[n - 1] = step(n - 2);
  right[n - 1] = 6 * (slope(true) - chord(n - 2));
  bend_ = rows.solved(right);
}

/// The corners of the matrix by Sherman and Morrison: it is a tridiagonal one and a product of two
/// vectors.
void Spline::solve_closed() {
  const std::size_t n = point_.size() - 1;
  const auto step = [&](std::size_t i) { return knot_[i % n + 1] - knot_[i % n]; };
  const auto chord = [&](std::size_t i) {
    return (1 / step(i)) * (point_[i % n + 1] - point_[i % n]);
  };
  Tridiagonal rows{std::vector<double>(n), std::vector<double>(n), std::vector<double>(n)};
  std::vector<Vec2> right(n), corner(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double before = step(i + n - 1), behind = step(i);
    rows.below[i] = before, rows.above[i] = behind, rows.here[i] = 2 * (before + behind);
    right[i] = 6 * (chord(i) - chord(i + n - 1));
  }
  const double at_corner = rows.below[0], share = -rows.here[0];
  rows.here[0] -= share;
  rows.here[n - 1] -= at_corner * at_corner / share;
  corner[0].x = share, corner[n - 1].x = at_corner;
  const std::vector<Vec2> own = rows.solved(right), other = rows.solved(corner);
  const double ratio = at_corner / share, below = 1 + other[0].x + ratio * other[n - 1].x;
  const Vec2 part = (1 / below) * (own[0] + ratio * own[n - 1]);
  bend_.clear();
  for (std::size_t i = 0; i < n; ++i) bend_.push_back(own[i] - other[i].x * part);
  bend_.push_back(bend_[0]);
}

CurvePoint Spline::at(std::size_t i, double chords) const {
  const double step = knot_[i + 1] - knot_[i], a = knot_[i + 1] - chords, b = chords - knot_[i];
  const Vec2 from = (1 / step) * point_[i] - (step / 6) * bend_[i],
             to = (1 / step) * point_[i + 1] - (step / 6) * bend_[i + 1];
  const double cube = 1 / (6 * step);
  return {(cube * a * a * a) * bend_[i] + (cube * b * b * b) * bend_[i + 1] + a * from + b * to,
          (-3 * cube * a * a) * bend_[i] + (3 * cube * b * b) * bend_[i + 1] + to - from,
          (a / step) * bend_[i] + (b / step) * bend_[i + 1]};
}

}  // namespace vortree::body
