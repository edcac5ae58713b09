#include "body/outlines/piece.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vortree::body {
namespace {

constexpr int points = 7;
constexpr double tolerance = 1e-13;

double length(Vec2 a) {
  return std::sqrt(dot(a, a));
}

double cross(Vec2 a, Vec2 b) {
  return a.x * b.y - a.y * b.x;
}

/// Chebyshev's points, the middle one exactly there.
double node(int j) {
  return j == points / 2 ? 0 : std::cos((2 * j + 1) * std::numbers::pi / (2 * points));
}

/// What the value at point j adds to the coefficient of u^m.
using NodeWeights = std::array<std::array<double, points>, points>;

/// T_k(u) as a polynomial: T_{k+1} = 2 u T_k - T_{k-1}.
NodeWeights chebyshev() {
  NodeWeights t{};
  t[0][0] = t[1][1] = 1;
  for (int k = 2; k < points; ++k)
    for (int m = 0; m < points; ++m) t[k][m] = (m > 0 ? 2 * t[k - 1][m - 1] : 0) - t[k - 2][m];
  return t;
}

NodeWeights through_nodes() {
  const NodeWeights t = chebyshev();
  NodeWeights all{};
  for (int j = 0; j < points; ++j)
    for (int k = 0; k < points; ++k) {
      const double at_node = std::cos(k * (2 * j + 1) * std::numbers::pi / (2 * points));
      for (int m = 0; m < points; ++m)
        all[m][j] += (k == 0 ? 1.0 : 2.0) / points * at_node * t[k][m];
    }
  return all;
}

double coefficient(int m, const std::array<double, points>& values) {
  static const NodeWeights weights = through_nodes();
  double sum = 0;
  for (int j = 0; j < points; ++j) sum += weights[m][j] * values[j];
  return sum;
}

}  // namespace

double curvature(const CurvePoint& c) {
  const double speed = length(c.first);
  return cross(c.first, c.second) / (speed * speed * speed);
}

Piece::Piece(const Curve& curve, double a, double b) : parameter((a + b) / 2), half((b - a) / 2) {
  std::array<double, points> x, y, speeds;
  double most = 0, fastest = 0;
  for (int j = 0; j < points; ++j) {
    const CurvePoint c = curve(parameter + half * node(j));
    x[j] = half * half * c.second.x;
    y[j] = half * half * c.second.y;
    speeds[j] = half * length(c.first);
    most = std::max({most, std::abs(x[j]), std::abs(y[j])});
    fastest = std::max(fastest, speeds[j]);
    if (j != points / 2) continue;
    middle_ = c.at;
    at_[1] = XAndY{half * c.first.x, half * c.first.y};
  }
  for (int m = 0; m < points; ++m) {
    const double share = 1.0 / ((m + 1) * (m + 2));
    at_[m + 2] = XAndY{share * coefficient(m, x), share * coefficient(m, y)};
    arc_[m + 1] = coefficient(m, speeds) / (m + 1);
  }
  const double odd = arc_[1] + arc_[3] + arc_[5] + arc_[7], even = arc_[2] + arc_[4] + arc_[6];
  arc_[0] = odd - even;
  length_ = 2 * odd;
  for (const double u : {std::cos(6 * std::numbers::pi / 7), std::cos(2 * std::numbers::pi / 7)}) {
    const CurvePoint c = curve(parameter + half * u), own = (*this)(u);
    const Vec2 off = half * half * c.second - own.second;
    const double slow = half * length(c.first) - speed(u);
    exact_ &=
        length(off) <= tolerance * most + 1e-15 * fastest && std::abs(slow) <= tolerance * fastest;
  }
}

double Piece::turning() const {
  const Vec2 a = (*this)(-1).first, b = (*this)(1).first;
  return std::abs(std::atan2(cross(a, b), dot(a, b)));
}

Vec2 Piece::at(double u) const {
  XAndY value = at_[8];
  for (int k = 7; k >= 0; --k) value = value * u + at_[k];
  return middle_ + Vec2{value[0], value[1]};
}

double Piece::arc(double u) const {
  double sum = arc_[7];
  for (int k = 6; k >= 0; --k) sum = sum * u + arc_[k];
  return sum;
}

double Piece::speed(double u) const {
  double sum = 7 * arc_[7];
  for (int k = 6; k >= 1; --k) sum = sum * u + k * arc_[k];
  return sum;
}

double Piece::sagitta() const {
  // |second|/8 times the square of the range of u, which is 2.
  double most = 0;
  for (int k = 2; k <= 8; ++k) most += k * (k - 1) * length({at_[k][0], at_[k][1]});
  return most / 2;
}

}  // namespace vortree::body
