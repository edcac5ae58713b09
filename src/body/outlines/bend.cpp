#include "body/outlines/bend.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace vortree::body {
namespace {

using std::numbers::pi;

/// Gauss's points of order 16, of one half, and their weights.
constexpr std::array<double, 4> gauss{0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                      0.9602898564975363},
    weight{0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};

Vec2 direction(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

/// By how much it has turned from its middle to a share of l.
double turned(const Bend& bend, double share) {
  return bend.turns * (share / 2 + std::sin(pi * share) / (2 * pi));
}

/// From the middle, which faces x, to a share of l: in two halves, each turns by pi/4 at most.
Vec2 way(const Bend& bend, double share) {
  Vec2 sum{};
  for (const double half : {0.25, 0.75})
    for (std::size_t k = 0; k < gauss.size(); ++k)
      for (const double side : {-0.25, 0.25})
        sum += weight[k] * direction(pi / 2 + turned(bend, share * (half + side * gauss[k])));
  return (bend.turns * bend.radius * share / 4) * sum;
}

Vec2 rotated(Vec2 a, double angle) {
  const Vec2 x = direction(angle);
  return {x.x * a.x - x.y * a.y, x.y * a.x + x.x * a.y};
}

}  // namespace

Vec2 Bend::end() const {
  const Vec2 there = way(*this, 1);
  return {-there.x, there.y};
}

double Bend::cut() const {
  const auto [inward, along] = end();
  return along * std::tan(turns / 2) - inward;
}

Stretch Bend::stretch(Vec2 middle, double faces, double from, double to) const {
  const double rate = turns * radius * (to - from);
  const auto at = [=, bend = *this](double share) {
    const double here = from + share * (to - from), cosine = std::cos(pi * here / 2);
    const Vec2 ahead = direction(faces + pi / 2 + turned(bend, here));
    return CurvePoint{middle + rotated(way(bend, here), faces), rate * ahead,
                      (rate * rate * cosine * cosine / bend.radius) * Vec2{-ahead.y, ahead.x}};
  };
  return {at, rate, turned(*this, to) - turned(*this, from)};
}

}  // namespace vortree::body
