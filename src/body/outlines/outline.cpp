#include "body/outlines/outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "body/outlines/chords.hpp"
#include "body/outlines/hull.hpp"

namespace vortree::body {
namespace {

constexpr double turn = 2 * std::numbers::pi;

/// A chord of more than this [rad] is a poor guess of where its piece is nearest.
constexpr double most_turning = 0.1;

double length(Vec2 a) {
  return std::sqrt(dot(a, a));
}

/// Halves of the stretch from a to b, and of these, until all are exact; at the last, a formula
/// that is no smoother has to do.
void add_pieces(std::vector<Piece>& all, const Curve& curve, double a, double b, int halvings) {
  const Piece whole(curve, a, b);
  if (halvings == 0 || (whole.exact() && whole.turning() < most_turning)) {
    all.push_back(whole);
    return;
  }
  add_pieces(all, curve, a, (a + b) / 2, halvings - 1);
  add_pieces(all, curve, (a + b) / 2, b, halvings - 1);
}

/// Even steps of the parameter, and the breaks between them.
std::vector<double> ends_of_stretches(const std::vector<double>& breaks) {
  constexpr int even = 128;
  std::vector<double> ends = breaks;
  for (int i = 0; i <= even; ++i) ends.push_back(turn * i / even);
  std::ranges::sort(ends);
  const auto same = [](double a, double b) { return b - a < 1e-9; };
  ends.erase(std::unique(ends.begin(), ends.end(), same), ends.end());
  ends.back() = turn;
  return ends;
}

std::vector<Piece> pieces_of(const Curve& curve, const std::vector<double>& breaks) {
  constexpr int halvings = 12;
  const std::vector<double> ends = ends_of_stretches(breaks);
  std::vector<Piece> all;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    add_pieces(all, curve, ends[i], ends[i + 1], halvings);
  return all;
}

std::vector<Vec2> starts_of(const std::vector<Piece>& pieces) {
  std::vector<Vec2> starts;
  for (const Piece& piece : pieces) starts.push_back(piece.at(-1));
  return starts;
}

Vec2 middle_of(const std::vector<Vec2>& places) {
  const auto [left, right] = std::ranges::minmax(places, {}, &Vec2::x);
  const auto [low, high] = std::ranges::minmax(places, {}, &Vec2::y);
  return {(left.x + right.x) / 2, (low.y + high.y) / 2};
}

/// A parameter of a piece on its way to where something is least.
struct Downhill {
  explicit Downhill(double start) : at(start) {}

  /// By a step that leads downhill, but never past where it has been, nor an end of the piece.
  void go(double step) {
    (step > 0 ? low : high) = at;
    (step > 0 ? was_low : was_high) = true;
    const double next = at + step;
    if (next > high)
      at = was_high ? (at + high) / 2 : high;
    else if (next < low)
      at = was_low ? (at + low) / 2 : low;
    else
      at = next;
  }

  double at, low = -1, high = 1;
  bool was_low = false, was_high = false;
};

class Outline final : public Shape {
 public:
  explicit Outline(std::vector<Piece> pieces)
      : pieces_(std::move(pieces)),
        chords_(starts_of(pieces_)),
        hull_(hull_of(starts_of(pieces_), pieces_)) {
    arc_.push_back(0);
    for (const Piece& piece : pieces_) arc_.push_back(arc_.back() + piece.arc());
  }

  double perimeter() const override { return arc_.back(); }

  Vec2 point(double arc) const override {
    arc -= perimeter() * std::floor(arc / perimeter());
    const auto above = std::ranges::upper_bound(arc_, arc) - arc_.begin();
    const int i = std::clamp(static_cast<int>(above) - 1, 0, count() - 1);
    const Piece& piece = pieces_[i];
    double u = 2 * (arc - arc_[i]) / piece.arc() - 1;
    for (int k = 0; k < 8; ++k) {
      const double step = (arc_[i] + piece.arc(u) - arc) / piece.speed(u);
      u -= step;
      if (std::abs(step) < 1e-8) break;
    }
    return piece.at(u);
  }

  WallPoint nearest(Vec2 at) const override {
    const Foot foot = foot_of(at);
    const CurvePoint& c = foot.at;
    const double speed = length(c.first);
    const Vec2 tangent = (1 / speed) * c.first, normal{tangent.y, -tangent.x};
    return {arc_[foot.piece] + pieces_[foot.piece].arc(foot.u), dot(at - c.at, normal), normal,
            dot(c.second, {-normal.x, -normal.y}) / (speed * speed)};
  }

  double distance(Vec2 at) const override {
    const CurvePoint c = foot_of(at).at;
    const Vec2 out{c.first.y, -c.first.x}, d = at - c.at;
    return std::copysign(length(d), dot(d, out));
  }

  bool beyond(Vec2 at, double d) const override { return hull_.beyond(at, d); }

  std::vector<OutlinePoint> trace() const override {
    constexpr int places = 512;
    std::vector<OutlinePoint> all;
    std::size_t i = 0;
    for (int k = 0; k < places; ++k) {
      const double t = turn * k / places;
      while (i + 1 < pieces_.size() && t > pieces_[i].parameter + pieces_[i].half * (1 + 1e-9)) ++i;
      const double u = (t - pieces_[i].parameter) / pieces_[i].half;
      const CurvePoint c = pieces_[i](u);
      all.push_back({c.at, curvature(c), arc_[i] + pieces_[i].arc(u)});
    }
    return all;
  }

 private:
  struct Foot {
    int piece;
    double u;
    CurvePoint at;
  };

  static Hull hull_of(const std::vector<Vec2>& places, const std::vector<Piece>& pieces) {
    double beside = 0;
    for (const Piece& piece : pieces) beside = std::max(beside, piece.sagitta());
    const Vec2 centre = middle_of(places);
    return {centre, [&](Vec2 along) {
              double most = 0;
              for (const Vec2 place : places) most = std::max(most, dot(place - centre, along));
              return most + beside;
            }};
  }

  int count() const { return static_cast<int>(pieces_.size()); }

  /// The next piece, or the one before.
  int beside(int piece, int way) const { return (piece + way + count()) % count(); }

  /// The change of u that takes |at - curve|^2 to its least value, by a step of third order
  /// (Chebyshev's) where that is a small correction to Newton's; always downhill.
  static double step(const PiecePoint& c, Vec2 at) {
    const Vec2 d = c.at - at;
    const double speed = dot(c.first, c.first), slope = dot(d, c.first),
                 bend = speed + dot(d, c.second);
    // Where the curve bends away this would go uphill: there the length of the curve serves.
    if (!(bend > 0.1 * speed)) return -slope / (bend > 0 ? bend : speed);
    const double newton = slope / bend,
                 more = newton * (3 * dot(c.first, c.second) + dot(d, c.third)) / (2 * bend);
    return std::abs(more) < 0.5 ? -newton * (1 + more) : -newton;
  }

  /// Where |at - curve|^2 has its least value.
  Foot foot_of(Vec2 at) const {
    const auto [side, share] = chords_.nearest(at);
    int piece = side, came = 0;  // +1 or -1 if it came over the end or the start of a piece
    Downhill u(2 * share - 1);
    for (int k = 0;; ++k) {
      const PiecePoint c = pieces_[piece](u.at);
      const double du = step(c, at);
      // Beyond this Taylor's series has the round-off of the polynomial.
      if (std::abs(du) < 1e-6) return {piece, u.at + du, c.on(du)};
      const int way = du > 0 ? 1 : -1;
      if (u.at != way && k < 60) {
        u.go(du);
        continue;
      }
      // At an end, and farther on: over it, unless from over there it was this way.
      if (u.at != way || came == -way) return {piece, u.at, c};
      came = way;
      piece = beside(piece, way);
      u = Downhill(-way);
    }
  }

  std::vector<Piece> pieces_;
  std::vector<double> arc_;
  Chords chords_;
  Hull hull_;
};

}  // namespace

std::unique_ptr<Shape> outline(const Curve& curve, const std::vector<double>& breaks) {
  return std::make_unique<Outline>(pieces_of(curve, breaks));
}

}  // namespace vortree::body
