#pragma once

#include <array>
#include <functional>

#include "base/vec2.hpp"

namespace vortree::body {

/// A place on a curve and its first two derivatives with respect to the parameter.
struct CurvePoint {
  Vec2 at, first, second;
};

/// A closed curve given by a parameter from 0 to 2 pi, anticlockwise, twice differentiable and
/// never standing still.
using Curve = std::function<CurvePoint(double parameter)>;

/// 1/m; positive where an anticlockwise curve is convex.
[[nodiscard]] double curvature(const CurvePoint&);

/// And the third.
struct PiecePoint : CurvePoint {
  Vec2 third;

  /// What Taylor's series makes of it a little farther on.
  [[nodiscard]] CurvePoint on(double du) const {
    const double half = du / 2, sixth = du / 3;
    return {at + du * (first + half * (second + sixth * third)),
            first + du * (second + half * third), second + du * third};
  }
};

/// A stretch of a curve as polynomials in u, -1 at its start and 1 at its end.
///
/// The second derivative goes through the formula's at seven points of Chebyshev, and place and
/// direction are its integrals from the middle on, so that none of the three has more than the
/// round-off of the formula's; so is the arc length that of the speed at these points.
class Piece {
 public:
  /// The stretch from parameter a to b.
  Piece(const Curve& curve, double a, double b);

  /// As far as the formula shows at two more points, where such polynomials err most: second
  /// derivative and speed are off by 1e-13 of their largest at most.
  [[nodiscard]] bool exact() const { return exact_; }

  /// By how much the direction turns from end to end [rad].
  [[nodiscard]] double turning() const;

  /// Derivatives with respect to u.
  [[nodiscard]] PiecePoint operator()(double u) const {
    XAndY value = at_[8], first{}, second{}, third{};
    for (int k = 7; k >= 0; --k) {
      third = third * u + second;
      second = second * u + first;
      first = first * u + value;
      value = value * u + at_[k];
    }
    return {
        {middle_ + Vec2{value[0], value[1]}, {first[0], first[1]}, {2 * second[0], 2 * second[1]}},
        {6 * third[0], 6 * third[1]}};
  }
  [[nodiscard]] Vec2 at(double u) const;

  /// Arc length from the start [m].
  [[nodiscard]] double arc(double u) const;
  [[nodiscard]] double arc() const { return length_; }
  [[nodiscard]] double speed(double u) const;

  /// No place of the piece is farther from its chord [m].
  [[nodiscard]] double sagitta() const;

  /// The parameter at the middle and half its range, so that t = middle + half u.
  double parameter, half;

 private:
  using XAndY [[gnu::vector_size(16)]] = double;

  Vec2 middle_;
  std::array<XAndY, 9> at_{};    // of u^k, from the middle on
  std::array<double, 8> arc_{};  // of u^k
  double length_ = 0;
  bool exact_ = true;
};

}  // namespace vortree::body
