#include "body/outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace vortree::body {
namespace {

constexpr double turn = 2 * std::numbers::pi;

double length(Vec2 a) {
  return std::sqrt(dot(a, a));
}

/// 1/m; positive where an anticlockwise curve is convex.
double curvature(const CurvePoint& c) {
  const double speed = length(c.first);
  return (c.first.x * c.second.y - c.first.y * c.second.x) / (speed * speed * speed);
}

class Outline final : public Shape {
 public:
  explicit Outline(Curve curve) : curve_(std::move(curve)) {
    arc_.push_back(0);
    for (int i = 0; i < pieces; ++i) {
      place_.push_back(curve_(parameter(i)));
      arc_.push_back(arc_.back() + arc_from(i, parameter(i + 1)));
    }
    low_ = high_ = place(0);
    for (int i = 1; i < pieces; ++i) {
      low_ = {std::min(low_.x, place(i).x), std::min(low_.y, place(i).y)};
      high_ = {std::max(high_.x, place(i).x), std::max(high_.y, place(i).y)};
    }
    // Between two places the curve stays within half its length there of one of them.
    double between = 0;
    for (int i = 0; i < pieces; ++i) between = std::max(between, (arc_[i + 1] - arc_[i]) / 2);
    low_ = low_ - Vec2{between, between};
    high_ = high_ + Vec2{between, between};
    for (int g = 0; g < groups; ++g)
      for (int i = g * of_group; i < (g + 1) * of_group; ++i)
        reach_[g] = std::max(reach_[g], length(place(i) - place(leader(g))));
  }

  double perimeter() const override { return arc_.back(); }

  Vec2 point(double arc) const override {
    arc -= perimeter() * std::floor(arc / perimeter());
    const auto above = std::ranges::upper_bound(arc_, arc) - arc_.begin();
    const int i = std::clamp(static_cast<int>(above) - 1, 0, pieces - 1);
    double t = parameter(i) + (arc - arc_[i]) / (arc_[i + 1] - arc_[i]) * turn / pieces;
    for (int k = 0; k < 8; ++k) t -= (arc_[i] + arc_from(i, t) - arc) / length(curve_(t).first);
    return curve_(t).at;
  }

  WallPoint nearest(Vec2 at) const override {
    const auto [t, c] = foot(at);
    const Vec2 tangent = (1 / length(c.first)) * c.first, normal{tangent.y, -tangent.x};
    const double round = t - turn * std::floor(t / turn);
    const int i = static_cast<int>(std::min(pieces - 1.0, round / turn * pieces));
    return {arc_[i] + arc_from(i, round), dot(at - c.at, normal), normal, curvature(c)};
  }

  double distance(Vec2 at) const override {
    const auto [t, c] = foot(at);
    const Vec2 out{c.first.y, -c.first.x}, d = at - c.at;
    return std::copysign(length(d), dot(d, out));
  }

  bool beyond(Vec2 at, double d) const override {
    return at.x < low_.x - d || at.x > high_.x + d || at.y < low_.y - d || at.y > high_.y + d;
  }

  std::vector<OutlinePoint> trace() const override {
    std::vector<OutlinePoint> all;
    for (const CurvePoint& c : place_) all.push_back({c.at, curvature(c)});
    return all;
  }

 private:
  static constexpr int pieces = 512, of_group = 16, groups = pieces / of_group;

  static double parameter(int i) { return turn * i / pieces; }
  static int leader(int group) { return group * of_group + of_group / 2; }
  Vec2 place(int i) const { return place_[i].at; }

  /// Length from place i on to a parameter nearby: three points of Gauss.
  double arc_from(int i, double t) const {
    const double a = parameter(i), h = t - a, g = std::sqrt(0.15);
    return h / 18 *
           (5 * length(curve_(a + (0.5 - g) * h).first) + 8 * length(curve_(a + 0.5 * h).first) +
            5 * length(curve_(a + (0.5 + g) * h).first));
  }

  struct Foot {
    double parameter;
    CurvePoint at;
  };

  /// The nearest of the places; a group whose leader is too far off has none.
  int nearest_place(Vec2 at) const {
    std::array<double, groups> square;
    double least = INFINITY;
    for (int g = 0; g < groups; ++g) {
      const Vec2 d = at - place(leader(g));
      square[g] = dot(d, d);
      least = std::min(least, square[g]);
    }
    const double near = std::sqrt(least) * (1 + 1e-12);
    int best = 0;
    least = INFINITY;
    for (int g = 0; g < groups; ++g) {
      if (square[g] > (near + reach_[g]) * (near + reach_[g])) continue;
      for (int i = g * of_group; i < (g + 1) * of_group; ++i) {
        const Vec2 d = at - place(i);
        if (const double d2 = dot(d, d); d2 < least) {
          least = d2;
          best = i;
        }
      }
    }
    return best;
  }

  /// Where |at - curve|^2 has its least value.
  Foot foot(Vec2 at) const {
    const int best = nearest_place(at);
    const double low = parameter(best - 1), high = parameter(best + 1);
    double t = parameter(best);
    CurvePoint c = place_[best];
    for (int k = 0; k < 20; ++k) {
      const Vec2 d = c.at - at;
      const double slope = dot(d, c.first), bend = dot(c.first, c.first) + dot(d, c.second);
      // Where the curve bends away Newton would go uphill: there the length of the curve serves.
      const double step = slope / (bend > 0 ? bend : dot(c.first, c.first));
      const double next = std::clamp(t - step, low, high);
      // The error of a step is as the square of it.
      const bool settled = std::abs(next - t) < 1e-7;
      t = next;
      c = curve_(t);
      if (settled) break;
    }
    return {t, c};
  }

  Curve curve_;
  std::vector<CurvePoint> place_;
  double reach_[groups]{};
  std::vector<double> arc_;
  Vec2 low_, high_;  // a box around the curve
};

}  // namespace

std::unique_ptr<Shape> outline(Curve curve) {
  return std::make_unique<Outline>(std::move(curve));
}

}  // namespace vortree::body
