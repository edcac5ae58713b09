#include "body/outlines/chords.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "tree/base/simd.hpp"

namespace vortree::body {
namespace {

/// Where sides stand that only fill a register, and farther off than anything is.
constexpr double nowhere = 1e150, farther = std::numeric_limits<double>::infinity();

double size(Vec2 a) {
  return std::sqrt(dot(a, a));
}

Lanes counted() {
  Lanes numbers;
  for (int i = 0; i < lane_count; ++i) numbers[i] = i;
  return numbers;
}

}  // namespace

/// The least of all lanes, and its number.
class Chords::Least {
 public:
  void take(Lanes square, Lanes number) {
    const auto less = square < square_;
    number_ = less ? number : number_;
    square_ = less ? square : square_;
  }
  double square() const {
    double least = square_[0];
    for (int i = 1; i < lane_count; ++i) least = square_[i] < least ? square_[i] : least;
    return least;
  }
  std::size_t number() const {
    const Lanes least = fill(square());
    const int lane = std::countr_zero(where(square_ <= least));
    double numbers[lane_count];
    store(numbers, number_);
    return static_cast<std::size_t>(numbers[lane]);
  }

 private:
  Lanes square_ = fill(farther), number_{};
};

Chords::Chords(std::span<const Vec2> joints) : groups_(padded(joints.size(), of_group) / of_group) {
  const std::size_t n = joints.size(), filled = groups_ * of_group;
  auto& [x, y, dx, dy, inverse] = sides_;
  for (auto* column : {&x, &y}) column->assign(filled, nowhere);
  for (auto* column : {&dx, &dy, &inverse}) column->assign(filled, 0);
  for (auto* column : {&leader_x_, &leader_y_}) column->assign(padded(groups_), nowhere);
  reach_.assign(padded(groups_), 0);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 a = joints[i], d = joints[(i + 1) % n] - a;
    x[i] = a.x, y[i] = a.y, dx[i] = d.x, dy[i] = d.y;
    inverse[i] = 1 / dot(d, d);
  }
  for (std::size_t g = 0; g < groups_; ++g) {
    const std::size_t first = g * of_group, last = std::min(n, first + of_group);
    const Vec2 leader = joints[(first + last) / 2 % n];
    leader_x_[g] = leader.x, leader_y_[g] = leader.y;
    for (std::size_t i = first; i <= last; ++i)
      reach_[g] = std::max(reach_[g], size(joints[i % n] - leader));
  }
}

inline std::size_t Chords::nearest_leader(Vec2 at) const {
  const Lanes px = fill(at.x), py = fill(at.y);
  Least best;
  Lanes number = counted();
  for (std::size_t g = 0; g < reach_.size(); g += lane_count) {
    const Lanes ex = px - load(&leader_x_[g]), ey = py - load(&leader_y_[g]);
    best.take(ex * ex + ey * ey, number);
    number += static_cast<double>(lane_count);
  }
  return best.number();
}

inline void Chords::take(Least& best, std::size_t group, Vec2 at) const {
  const auto& [x, y, dx, dy, inverse] = sides_;
  const Lanes px = fill(at.x), py = fill(at.y);
  for (std::size_t i = group * of_group; i < (group + 1) * of_group; i += lane_count) {
    const Lanes ax = px - load(&x[i]), ay = py - load(&y[i]), ux = load(&dx[i]), uy = load(&dy[i]);
    const Lanes along = (ax * ux + ay * uy) * load(&inverse[i]);
    const Lanes share = smaller(larger(along, Lanes{}), fill(1.0));
    const Lanes ex = ax - share * ux, ey = ay - share * uy;
    best.take(ex * ex + ey * ey, static_cast<double>(i) + counted());
  }
}

/// Those that may still have a nearer one than `but` and the groups beside it, which are asked by
/// now: seldom any.
inline void Chords::take_others(Least& best, std::size_t but, Vec2 at) const {
  const Lanes px = fill(at.x), py = fill(at.y), near = fill(std::sqrt(best.square()));
  Lanes from = counted() - static_cast<double>(but);
  for (std::size_t g = 0; g < reach_.size(); g += lane_count) {
    const Lanes ex = px - load(&leader_x_[g]), ey = py - load(&leader_y_[g]),
                reach = near + load(&reach_[g]);
    const auto close = (ex * ex + ey * ey < reach * reach) & (magnitude(from) > 1.0);
    from += static_cast<double>(lane_count);
    for (LaneSet some = where(close); some != 0; some &= some - 1)
      take(best, g + std::countr_zero(some), at);
  }
}

Chords::NearestSide Chords::nearest(Vec2 at) const {
  const std::size_t leader = nearest_leader(at);
  Least best;
  take(best, leader == 0 ? groups_ - 1 : leader - 1, at);
  take(best, leader, at);
  take(best, leader + 1 == groups_ ? 0 : leader + 1, at);
  take_others(best, leader, at);
  const auto& [x, y, dx, dy, inverse] = sides_;
  const std::size_t side = best.number();
  const double along = ((at.x - x[side]) * dx[side] + (at.y - y[side]) * dy[side]) * inverse[side];
  return {static_cast<int>(side), std::clamp(along, 0.0, 1.0)};
}

}  // namespace vortree::body
