#include "vortex/adapt/merge_close.hpp"

#include <omp.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>

#include "tree/base/numbers_where.hpp"
#include "vortex/adapt/bins.hpp"
#include "vortex/adapt/merge_kernel.hpp"
#include "vortex/adapt/merge_windows.hpp"
#include "vortex/adapt/tuning.hpp"

namespace vortree::vortex {
namespace {

using merge_kernel::Limits;
using merge_kernel::MergeChoice;
using merge_kernel::none;

/// Merges like signed blobs wherever they are, until no pair is left.
class Remainder {
 public:
  Remainder(std::span<AdaptedBlob> adapted, std::span<AtWall> at_wall, const Merging& merging);

  /// Flags in `gone` those that have merged into others; false if they crowd too much.
  [[nodiscard]] bool merge(std::span<char> gone);

 private:
  using Number = std::uint32_t;

  void look_at(Number i) {
    const AdaptedBlob& p = adapted_[i];
    candidates_.put(slot_[i], limits_.units, p.centre(), std::abs(p.gamma), p.square,
                    {p.widening, p.leniency});
  }
  bool crowded() const { return looked_ > std::max(most_looks * adapted_.size(), few_looks); }
  double reach_of(std::size_t slot) const;
  std::size_t seek_together(std::span<const Number> seeking);
  void seek_alone(Number i);
  void choose(std::span<const Number> seeking);
  std::vector<std::pair<Number, Number>> mutual_pairs();
  void join(Number into, Number other);
  std::vector<Number> deserted();

  std::span<AdaptedBlob> adapted_;
  std::span<AtWall> at_wall_;
  Limits limits_;
  double side_;  // of what seeks together
  Bins bins_;
  std::vector<Number> slot_;  // place in the bins' order, which is that of the candidates
  merge_kernel::MergeColumns<std::vector<float>> candidates_;
  std::vector<float> home_x_, home_y_;  // of candidates when they were binned
  float farthest_from_home_ = 0;
  std::vector<MergeChoice> choice_;
  std::vector<Number> choosers_;  // all who have a choice
  std::vector<char> paired_;
  std::atomic<std::size_t> looked_ = 0;  // at candidates
};

Bins binned(std::span<const AdaptedBlob> adapted, double side) {
  std::vector<double> x(adapted.size()), y(adapted.size());
  for (std::size_t i = 0; i < adapted.size(); ++i) {
    x[i] = adapted[i].x;
    y[i] = adapted[i].y;
  }
  return Bins(x, y, side);
}

Remainder::Remainder(std::span<AdaptedBlob> adapted, std::span<AtWall> at_wall,
                     const Merging& merging)
    : adapted_(adapted),
      at_wall_(at_wall),
      limits_(merging),
      side_(seekers_side * merging.sigma_max),
      bins_(binned(adapted, merging.reach * merging.sigma_max / bins_a_reach)),
      slot_(adapted.size()),
      choice_(adapted.size()),
      paired_(adapted.size()) {
  candidates_.resize(adapted.size() + single_count);
  std::fill(candidates_.x.begin() + adapted.size(), candidates_.x.end(), merge_kernel::never);
  const std::ptrdiff_t n = std::ssize(adapted);
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t k = 0; k < n; ++k) {
    const Number i = bins_.order()[k];
    slot_[i] = static_cast<Number>(k);
    look_at(i);
  }
  home_x_ = candidates_.x;
  home_y_ = candidates_.y;
}

/// Partners of no smaller circulation: the error allows them no farther away than for half this
/// blob's circulation. Smaller ones choose this blob themselves.
double Remainder::reach_of(std::size_t slot) const {
  const float allowed =
      2 * limits_.tolerance / (candidates_.gamma[slot] * candidates_.inverse_cube[slot]);
  const float within = std::sqrt(std::min(limits_.reach2 * candidates_.square[slot], allowed));
  return (1.00001 * within + farthest_from_home_) / limits_.units.per_length;
}

/// The first of these, and as many more as fit a vector and lie close, choose their partners.
/// Returns how many.
std::size_t Remainder::seek_together(std::span<const Number> seeking) {
  merge_kernel::Seekers<Singles> seekers;
  Vec2 low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  const AdaptedBlob& first = adapted_[seeking[0]];
  for (Number i : seeking.first(std::min(seeking.size(), seekers.most))) {
    const AdaptedBlob& p = adapted_[i];
    if (std::max(std::abs(p.x - first.x), std::abs(p.y - first.y)) > side_) break;
    const Number slot = slot_[i];
    seekers.add(candidates_, slot, slot);
    const double reach = reach_of(slot);
    low = {std::min(low.x, p.x - reach), std::min(low.y, p.y - reach)};
    high = {std::max(high.x, p.x + reach), std::max(high.y, p.y + reach)};
  }
  seekers.choose(candidates_, limits_, [&](auto consider) {
    std::size_t looked = 0;
    bins_.runs_in(low, high, [&](Number from, Number to) {
      for (Number slot = from; slot < to; ++slot) consider(slot);
      looked += to - from;
    });
    looked_.fetch_add(looked, std::memory_order_relaxed);
  });
  for (std::size_t k = 0; k < seekers.size(); ++k) {
    MergeChoice choice = seekers.choice(k);
    if (choice.partner != none) choice.partner = bins_.order()[choice.partner];
    choice_[seeking[k]] = choice;
  }
  return seekers.size();
}

void Remainder::seek_alone(Number i) {
  const AdaptedBlob& p = adapted_[i];
  const double reach = reach_of(slot_[i]);
  merge_kernel::LoneSeeker seeker(candidates_, slot_[i]);
  std::size_t looked = 0;
  bins_.runs_near(p.centre(), reach, [&](Number from, Number to) {
    seeker.consider(candidates_, from, to, limits_);
    looked += to - from;
  });
  looked_.fetch_add(looked, std::memory_order_relaxed);
  choice_[i] = seeker.choice();
  if (choice_[i].partner != none) choice_[i].partner = bins_.order()[choice_[i].partner];
}

/// Those who seek choose among all, then all are offered to those they have chosen.
void Remainder::choose(std::span<const Number> seeking) {
  const std::size_t turns = (seeking.size() + seekers_a_turn - 1) / seekers_a_turn;
  // When all seek, neighbors look at the same candidates; few seldom are neighbors.
  const bool together = seeking.size() == adapted_.size();
#pragma omp parallel for schedule(dynamic, 1)
  for (std::size_t turn = 0; turn < turns; ++turn) {
    auto left = seeking.subspan(turn * seekers_a_turn);
    left = left.first(std::min(seekers_a_turn, left.size()));
    if (!together)
      for (Number i : left) seek_alone(i);
    else
      while (!left.empty()) left = left.subspan(seek_together(left));
  }
  for (Number i : seeking)
    if (choice_[i].partner != none) choosers_.push_back(i);
  for (std::size_t k = 0; k < choosers_.size(); ++k) {
    const Number i = choosers_[k];
    const MergeChoice mine = choice_[i];
    MergeChoice& theirs = choice_[mine.partner];
    if (theirs.partner == none) choosers_.push_back(mine.partner);
    if (mine.error < theirs.error || (mine.error == theirs.error && i < theirs.partner))
      theirs = {i, mine.error};
  }
}

std::vector<std::pair<Remainder::Number, Remainder::Number>> Remainder::mutual_pairs() {
  std::vector<std::pair<Number, Number>> pairs;
  for (Number i : choosers_)
    if (const Number j = choice_[i].partner; i < j && choice_[j].partner == i) {
      pairs.emplace_back(i, j);
      paired_[i] = paired_[j] = 1;
    }
  return pairs;
}

void Remainder::join(Number into, Number other) {
  merge_kernel::merge(adapted_[into], adapted_[other], at_wall_);
  look_at(into);
  const Number slot = slot_[into];
  candidates_.x[slot_[other]] = merge_kernel::never;  // out of everybody's reach
  farthest_from_home_ = std::max(
      farthest_from_home_,
      std::hypot(candidates_.x[slot] - home_x_[slot], candidates_.y[slot] - home_y_[slot]));
}

/// Takes those who have merged, and those whose choice has, out of the choosers.
std::vector<Remainder::Number> Remainder::deserted() {
  std::vector<Number> seeking;
  std::erase_if(choosers_, [&](Number i) {
    const bool alone = paired_[i] || paired_[choice_[i].partner];
    if (alone) seeking.push_back(i);
    return alone;
  });
  std::ranges::sort(seeking);
  return seeking;
}

bool Remainder::merge(std::span<char> gone) {
  std::vector<Number> seeking(adapted_.size());
  std::iota(seeking.begin(), seeking.end(), 0u);
  while (!seeking.empty()) {
    choose(seeking);
    if (crowded()) return false;
    const auto pairs = mutual_pairs();
    for (const auto& [into, other] : pairs) {
      join(into, other);
      gone[other] = 1;
    }
    seeking = deserted();
    for (const auto& [into, other] : pairs) paired_[into] = paired_[other] = 0;
    for (Number i : seeking) choice_[i] = {};
    std::erase_if(seeking, [&](Number i) { return gone[i]; });
  }
  return true;
}

void merge_remainder(AdaptedBlobs& adapted, const Merging& merging) {
  std::vector<char> gone(adapted.all.size());
  const auto negative =
      std::ranges::find_if(adapted.all, [](const AdaptedBlob& p) { return p.gamma < 0; });
  const std::size_t split = negative - adapted.all.begin(), n = adapted.all.size();
  const std::array borders{std::size_t{0}, split, n};
  const int threads = omp_get_max_threads();
  const bool both = split > 0 && split < n && threads > 1 && threads <= threads_by_sign;
  std::array<bool, 2> merged{true, true};
#pragma omp parallel for schedule(static, 1) num_threads(2) if (both)
  for (int sign = 0; sign < 2; ++sign) {
    const std::size_t first = borders[sign], size = borders[sign + 1] - first;
    if (size > 0)
      merged[sign] = Remainder({&adapted.all[first], size}, adapted.at_wall, merging)
                         .merge({&gone[first], size});
  }
  if (!merged[0] || !merged[1]) throw Crowded(n);
  std::size_t left = 0;
  for (std::size_t i = 0; i < n; ++i)
    if (!gone[i]) adapted.all[left++] = adapted.all[i];
  adapted.all.resize(left);
}

void merge_all(AdaptedBlobs& adapted, const Merging& merging) {
  // What lies within a core or so merges in windows.
  Merging near = merging;
  double shift = 0;
  for (double cores : window_reaches) {
    near.reach = std::min(merging.reach, cores);
    merge_in_windows(adapted, near, shift);
    shift += window_shift;
  }
  merge_remainder(adapted, merging);
}

/// Takes out and returns those on a lattice that may merge with none as strong a core away.
Unwritten<AdaptedBlob> take_strong(Unwritten<AdaptedBlob>& all, double tolerance) {
  const auto strong = [&](std::uint32_t i) {
    const AdaptedBlob& p = all[i];
    return p.leniency < p.widening &&
           std::abs(p.gamma) / 2 > tolerance * p.leniency * std::sqrt(p.square);
  };
  const auto weak = [&](std::uint32_t i) { return !strong(i); };
  const auto those = [&](const auto& hold) {
    return tree::made_of<AdaptedBlob>(tree::numbers_where(all.size(), hold),
                                      [&](std::uint32_t i) { return all[i]; });
  };
  Unwritten<AdaptedBlob> taken = those(strong);
  all = those(weak);
  return taken;
}

}  // namespace

void merge_close(AdaptedBlobs& adapted, const Merging& merging) {
  if (merging.tolerance <= 0 || adapted.all.size() < 2) return;
  const Unwritten<AdaptedBlob> strong = take_strong(adapted.all, merging.tolerance);
  if (!adapted.all.empty()) merge_all(adapted, merging);
  adapted.all.insert(adapted.all.end(), strong.begin(), strong.end());
}

void merge_close(Blobs& blobs, const Merging& merging, const body::Shape* wall) {
  if (merging.tolerance <= 0 || blobs.size() < 2) return;
  AdaptedBlobs adapted = unpack(blobs, wall);
  merge_close(adapted, merging);
  blobs = pack(adapted, wall);
}

}  // namespace vortree::vortex
