#include "vortex/adapt/merge_kernel.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace vortree::vortex::merge_kernel {

namespace {

/// Halfway between two normals; of those of both sides of a plate, which are opposite, the first.
Vec2 halfway(Vec2 a, Vec2 b) {
  constexpr double opposite = 1e-12;
  const Vec2 sum = a + b;
  return dot(sum, sum) > opposite ? (1 / std::sqrt(dot(sum, sum))) * sum : a;
}

/// Two blobs of which at least one lies beside the wall: `w` is the first's share.
struct PairAtWall {
  const AdaptedBlob &p, &q;
  std::span<const AtWall> at_wall;
  double w;
  Vec2 normal, folded_apart;

  PairAtWall(const AdaptedBlob& first, const AdaptedBlob& second, double share,
             std::span<const AtWall> all)
      : p(first), q(second), at_wall(all), w(share) {
    normal = halfway(of(p).normal, of(q).normal);
    folded_apart = p.centre() - q.centre() + offset(p) - offset(q);
  }

  bool folds(const AdaptedBlob& blob) const { return blob.at_wall != no_wall; }
  /// What is known of the wall: of the other, if it does not fold this one.
  const AtWall& of(const AdaptedBlob& blob) const {
    return at_wall[folds(blob) ? blob.at_wall : folds(p) ? p.at_wall : q.at_wall];
  }
  Vec2 offset(const AdaptedBlob& blob) const { return folds(blob) ? of(blob).offset : Vec2{}; }
  double across(const AdaptedBlob& blob) const {
    return folds(blob) ? of(blob).across : blob.core().covariance(normal).nn;
  }
  /// How much farther from the wall the first is: along the bent wall, if both are known.
  double farther() const {
    return folds(p) && folds(q) ? of(p).mean - of(q).mean : dot(normal, folded_apart);
  }

  AtWall merged() const {
    const double v = 1 - w, apart = farther();
    const double mean = folds(p) ? of(p).mean - v * apart : of(q).mean + w * apart;
    return {w * offset(p) + v * offset(q), normal, mean,
            w * across(p) + v * across(q) + w * v * apart * apart, true};
  }
};

/// What lies beside the wall of both, the second's share added to the first's. Tilt is that of
/// folded centroids.
void merge_at_wall(AdaptedBlob& p, const AdaptedBlob& q, double w, Covariance& spread, Vec2& normal,
                   std::span<AtWall> at_wall) {
  const PairAtWall pair(p, q, w, at_wall);
  normal = pair.normal;
  const Vec2 tangent{-normal.y, normal.x}, apart = p.centre() - q.centre();
  spread = {dot(normal, apart) * dot(normal, apart),
            dot(normal, pair.folded_apart) * dot(tangent, pair.folded_apart),
            dot(tangent, apart) * dot(tangent, apart)};
  const AtWall merged = pair.merged();
  if (p.at_wall == no_wall) p.at_wall = q.at_wall;
  at_wall[p.at_wall] = merged;
}

}  // namespace

void merge(AdaptedBlob& p, const AdaptedBlob& q, std::span<AtWall> at_wall) {
  const double gamma = p.gamma + q.gamma, w = gamma != 0 ? p.gamma / gamma : 0.5;
  const Vec2 apart = p.centre() - q.centre();
  Vec2 axis{1, 0};
  Covariance spread{apart.x * apart.x, apart.x * apart.y, apart.y * apart.y};
  if (p.at_wall != no_wall || q.at_wall != no_wall) merge_at_wall(p, q, w, spread, axis, at_wall);
  const Core between = core_of(spread, axis);
  const Vec2 at = w * p.centre() + (1 - w) * q.centre();
  p.x = at.x;
  p.y = at.y;
  p.square = w * p.square + (1 - w) * q.square + w * (1 - w) * between.square;
  p.deviator = w * p.deviator + (1 - w) * q.deviator + w * (1 - w) * between.deviator;
  p.gamma = gamma;
  p.widening = std::min(p.widening, q.widening);
  p.leniency = std::min(p.leniency, q.leniency);
}

namespace {

void for_each(std::uint32_t set, auto use) {
  for (; set != 0; set &= set - 1) use(static_cast<std::uint8_t>(std::countr_zero(set)));
}
constexpr std::uint32_t bit(std::uint8_t i) {
  return 1u << i;
}

}  // namespace

/// Those who seek, a vector of them at a time, look at all who live.
void MergeWindow::choose(const Limits& limits) {
  chose_ &= ~seeking_;
  for (Set left = seeking_; left != 0;) {
    Seekers<Singles> seekers;
    std::array<Number, single_count> who;
    for (; left != 0 && seekers.size() < single_count; left &= left - 1) {
      const auto i = static_cast<Number>(std::countr_zero(left));
      who[seekers.size()] = i;
      seekers.add(traits_, i, i);
    }
    seekers.choose(traits_, limits,
                   [&](auto consider) { for_each(alive_, [&](Number i) { consider(i); }); });
    for (std::size_t k = 0; k < seekers.size(); ++k) {
      const MergeChoice choice = seekers.choice(k);
      error_[who[k]] = choice.error;
      partner_[who[k]] = static_cast<Number>(choice.partner);
      chose_ |= choice.partner != none ? bit(who[k]) : 0;
    }
  }
}

/// Those who chose are offered to whom they chose.
void MergeWindow::offer() {
  for_each(seeking_ & chose_, [&](Number i) {
    const Number j = partner_[i];
    if (error_[i] >= error_[j]) return;
    error_[j] = error_[i];
    partner_[j] = i;
    chose_ |= bit(j);
  });
}

/// The first of each mutual pair; they and those they have left alone seek again.
MergeWindow::Set MergeWindow::pair_up() {
  Set first = 0, second = 0, alone = 0;
  for_each(chose_, [&](Number i) {
    const Number j = partner_[i];
    const bool mutual = partner_[j] == i && i < j;
    first |= mutual ? bit(i) : 0;
    second |= mutual ? bit(j) : 0;
  });
  const Set paired = first | second;
  for_each(chose_ & ~paired, [&](Number i) { alone |= paired & bit(partner_[i]) ? bit(i) : 0; });
  alive_ &= ~second;
  chose_ &= ~second;
  seeking_ = first | alone;
  return first;
}

void MergeWindow::look_at(std::span<const std::uint32_t> members,
                          std::span<const AdaptedBlob> adapted, const Limits& limits) {
  const Vec2 first = adapted[members[0]].centre();
  for (std::size_t i = 0; i < members.size(); ++i) {
    const AdaptedBlob& p = adapted[members[i]];
    traits_.put(i, limits.units, p.centre() - first, std::abs(p.gamma), p.square,
                {p.widening, p.leniency});
  }
}

std::size_t MergeWindow::merge(std::span<std::uint32_t> members, std::span<AdaptedBlob> adapted,
                               std::span<AtWall> at_wall, const Limits& limits) {
  const Vec2 first_place = adapted[members[0]].centre();
  look_at(members, adapted, limits);
  error_.fill(never);
  partner_.fill(nobody);
  chose_ = 0;
  alive_ = seeking_ = static_cast<Set>(~0ull >> (64 - members.size()));
  while (true) {
    choose(limits);
    offer();
    const Set first = pair_up();
    if (first == 0) break;
    for_each(first, [&](Number i) {
      AdaptedBlob& p = adapted[members[i]];
      merge_kernel::merge(p, adapted[members[partner_[i]]], at_wall);
      traits_.put(i, limits.units, p.centre() - first_place, std::abs(p.gamma), p.square,
                  {p.widening, p.leniency});
    });
  }
  std::size_t left = 0;
  for_each(alive_, [&](Number i) { members[left++] = members[i]; });
  return left;
}

}  // namespace vortree::vortex::merge_kernel
