#include "fmm/mutual/mutual_cores.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace vortree::fmm {
namespace {

// Squared extent over the least S, for single precision; where no core shows.
constexpr double widest_frame2 = 256.0, widest_bare_frame2 = 4096.0;
constexpr double widest_core = 1e12;  // largest over least S, likewise

/// `use(weight)` with what sums pairs with cores.
template <class Use>
void with_weight(Cores cores, bool coarse, Use use) {
  if (cores == Cores::mean) {
    return coarse ? use(MutualMeanCore<CoarseExp>{}) : use(MutualMeanCore<FineExp>{});
  }
  coarse ? use(MutualSourceCore<CoarseExp>{}) : use(MutualSourceCore<FineExp>{});
}

/// `count` values, scaled; a vector's second half that is not there is a copy of the first.
template <class Number>
typename VectorOf<Number>::Type load_scaled(const double* from, std::uint32_t count, double origin,
                                            double scale) {
  const Lanes first = (load(from) - origin) * scale;
  if constexpr (std::is_same_v<Number, double>)
    return first;
  else
    return narrowed(first, count > lane_count ? (load(from + lane_count) - origin) * scale : first);
}

template <class Number>
typename VectorOf<Number>::Type load_gamma(const double* from, std::uint32_t count) {
  if constexpr (std::is_same_v<Number, double>)
    return load(from);
  else
    return narrowed(load(from), count > lane_count ? load(from + lane_count) : Lanes{});
}

template <class Vector>
void add_scaled(double* to, std::uint32_t count, Vector sums, double scale) {
  if constexpr (std::is_same_v<Vector, Lanes>) {
    store(to, load(to) + sums * scale);
  } else {
    store(to, load(to) + low(sums) * scale);
    if (count > lane_count) store(to + lane_count, load(to + lane_count) + high(sums) * scale);
  }
}

tree::Range common(tree::Range a, tree::Range b) {
  const std::uint32_t first = std::max(a.first, b.first);
  return {first, std::max(first, std::min(a.last, b.last))};
}

}  // namespace

template <std::size_t sums>
MutualCores<sums>::MutualCores(const Leaves& leaves, Cores cores, double reach2, bool coarse)
    : leaves_(leaves), cores_(cores), reach2_(reach2), coarse_(coarse) {}

template <std::size_t sums>
void MutualCores<sums>::add(std::uint32_t leaf, tree::Range leaf_run,
                            std::span<const tree::Range> runs, const Sums& to) {
  take(leaf);
  const tree::Range own{leaves_.start[leaf], leaves_.start[leaf + 1]};
  for (const tree::Range run : runs) {
    meet<false>(common(run, {0, leaf_run.first}), to);
    if (!common(run, own).empty()) meet_itself(to);
    meet<true>(common(run, {own.last, leaf_run.last}), to);
    meet<false>(common(run, {leaf_run.last, run.last}), to);
  }
  empty_room(room_, to);
  empty_room(single_, to);
}

template <std::size_t sums>
void MutualCores<sums>::take(std::uint32_t leaf) {
  first_ = leaves_.start[leaf], size_ = leaves_.size[leaf];
  Lanes left = load(&leaves_.points.x[first_]), bottom = load(&leaves_.points.y[first_]);
  Lanes right = left, top = bottom, least = load(&leaves_.points.core[first_]), widest = least;
  for (std::uint32_t j = first_ + lane_count; j < first_ + size_; j += lane_count) {
    const Lanes x = load(&leaves_.points.x[j]), y = load(&leaves_.points.y[j]);
    const Lanes core = load(&leaves_.points.core[j]);
    left = smaller(x, left), right = larger(x, right);
    bottom = smaller(y, bottom), top = larger(y, top);
    least = smaller(core, least), widest = larger(core, widest);
  }
  const double x0 = -largest(-left), x1 = largest(right), y0 = -largest(-bottom), y1 = largest(top);
  x_ = 0.5 * x0 + 0.5 * x1, y_ = 0.5 * y0 + 0.5 * y1;
  half_x_ = std::max(x1 - x_, x_ - x0), half_y_ = std::max(y1 - y_, y_ - y0);
  least_ = -largest(-least), widest_ = largest(widest);
  const double half = std::max(half_x_, half_y_);
  fits_ = least_ > 0.0 && half * half <= widest_frame2 * least_ && widest_ <= widest_core * least_;
  fits_bare_ =
      least_ > 0.0 && half * half <= widest_bare_frame2 * least_ && widest_ <= widest_core * least_;
  single_.x0 = x_, single_.y0 = y_;
  single_.per_length = least_ > 0.0 ? 1.0 / std::sqrt(least_) : 1.0;
}

template <std::size_t sums>
template <class Number>
void MutualCores<sums>::fill_room(Room<Number>& room) const {
  room.open = true;
  const std::size_t whole = padded(size_), in_vectors = padded(size_, VectorOf<Number>::count);
  if (room.x.size() < in_vectors) {
    for (auto* values : {&room.x, &room.y, &room.gamma, &room.core}) values->resize(2 * in_vectors);
    for (auto& sum : room.sum) sum.resize(2 * in_vectors);
  }
  const double per_area = room.per_length * room.per_length;
  with_weight(cores_, coarse_, [&](auto weight) {
    for (std::size_t i = 0; i < whole; ++i) {
      const std::size_t j = first_ + i;
      room.x[i] = static_cast<Number>((leaves_.points.x[j] - room.x0) * room.per_length);
      room.y[i] = static_cast<Number>((leaves_.points.y[j] - room.y0) * room.per_length);
      room.gamma[i] = static_cast<Number>(leaves_.gamma[j]);
      room.core[i] = weight.packed(static_cast<Number>(leaves_.points.core[j] * per_area));
    }
  });
  for (auto& sum : room.sum)
    std::fill_n(sum.begin(), in_vectors, typename VectorOf<Number>::Type{});
}

template <std::size_t sums>
template <class Number>
void MutualCores<sums>::empty_room(Room<Number>& room, const Sums& to) const {
  if (!room.open) return;
  room.open = false;
  constexpr std::uint32_t n = VectorOf<Number>::count;
  for (std::size_t s = 0; s < sums; ++s) {
    for (std::uint32_t i = 0; i < size_; i += n) {
      add_scaled(to[s] + first_ + i, size_ - i, side_by_side<Number>(&room.sum[s][i]),
                 room.scale(s));
    }
  }
}

template <std::size_t sums>
auto MutualCores<sums>::look(std::uint32_t first, std::uint32_t count, bool both) const -> Look {
  const double part = cores_ == Cores::mean ? 0.5 * reach2_ : reach2_;
  const double of_cell = cores_ == Cores::mean ? part * widest_ : 0.0;
  const Lanes at_least = fill(cores_ == Cores::source && both ? part * widest_ : 0.0);
  LaneSet shown = 0, unfit = 0, unfit_bare = 0;
  for (std::uint32_t j = first; j < first + count; j += lane_count) {
    const Lanes from_x = magnitude(load(&leaves_.points.x[j]) - x_);
    const Lanes from_y = magnitude(load(&leaves_.points.y[j]) - y_);
    const Lanes core = load(&leaves_.points.core[j]);
    const Lanes dx = larger(from_x - half_x_, Lanes{}), dy = larger(from_y - half_y_, Lanes{});
    shown |= where(dx * dx + dy * dy < larger(part * core + of_cell, at_least));
    const Lanes extent = larger(from_x, from_y), least = smaller(core, fill(least_));
    const LaneSet uneven = where(core > widest_core * least);
    unfit |= where(extent * extent > widest_frame2 * least) | uneven;
    unfit_bare |= where(extent * extent > widest_bare_frame2 * least) | uneven;
  }
  const bool fit = shown != 0 ? fits_ && unfit == 0 : fits_bare_ && unfit_bare == 0;
  return {shown != 0, coarse_ && fit};
}

template <std::size_t sums>
template <bool both>
void MutualCores<sums>::meet(tree::Range places, const Sums& to) {
  const std::uint32_t step = coarse_ ? single_count : lane_count;
  for (std::uint32_t j = places.first; j < places.last; j += step) {
    const std::uint32_t count = std::min(step, places.last - j);
    const Look seen = look(j, count, both);
    if (seen.single) {
      meet_some<both>(single_, {0, size_}, j, count, seen.shows, to);
    } else {
      for (std::uint32_t k = 0; k < count; k += lane_count) {
        meet_some<both>(room_, {0, size_}, j + k, lane_count, seen.shows, to);
      }
    }
  }
}

/// The points of the cell upon each other: a vector of them upon itself, and with those behind it
/// both ways.
template <std::size_t sums>
void MutualCores<sums>::meet_itself(const Sums& to) {
  const auto meet_behind = [&](auto& room, std::uint32_t j, std::uint32_t count, bool shows) {
    const std::uint32_t behind = std::min(j + count, size_);
    meet_some<false>(room, {j, behind}, first_ + j, count, shows, to);
    if (behind < size_) meet_some<true>(room, {behind, size_}, first_ + j, count, shows, to);
  };
  const std::uint32_t step = coarse_ ? single_count : lane_count;
  const auto whole = static_cast<std::uint32_t>(padded(size_));
  for (std::uint32_t j = 0; j < whole; j += step) {
    const std::uint32_t count = std::min(step, whole - j);
    const Look seen = look(first_ + j, count, true);
    if (seen.single) {
      meet_behind(single_, j, count, seen.shows);
    } else {
      for (std::uint32_t k = j; k < j + count; k += lane_count) {
        meet_behind(room_, k, lane_count, seen.shows);
      }
    }
  }
}

template <std::size_t sums>
template <bool both, class Number>
void MutualCores<sums>::meet_some(Room<Number>& room, tree::Range points, std::uint32_t first,
                                  std::uint32_t count, bool shows, const Sums& to) const {
  using Vector = typename VectorOf<Number>::Type;
  if (!room.open) fill_room(room);
  const std::uint32_t from = points.first;
  CellPoints<Number, sums> cell{
      &room.x[from], &room.y[from], &room.gamma[from], &room.core[from], {}, points.size()};
  for (std::size_t s = 0; s < sums; ++s) cell.sum[s] = &room.sum[s][from];
  OtherPoints<Vector, sums> others;
  others.x = load_scaled<Number>(&leaves_.points.x[first], count, room.x0, room.per_length);
  others.y = load_scaled<Number>(&leaves_.points.y[first], count, room.y0, room.per_length);
  others.gamma = load_gamma<Number>(&leaves_.gamma[first], count);
  if (!shows) {
    meet_bare<both>(cell, others);
  } else {
    const double per_area = room.per_length * room.per_length;
    const Vector core = load_scaled<Number>(&leaves_.points.core[first], count, 0.0, per_area);
    with_weight(cores_, coarse_, [&](auto weight) {
      others.core = weight.packed(core);
      meet_cored<decltype(weight), both>(cell, others);
    });
  }
  if (!both) return;
  for (std::size_t s = 0; s < sums; ++s)
    add_scaled(to[s] + first, count, others.sum[s], room.scale(s));
}

template class MutualCores<velocity_sums>;
template class MutualCores<slope_sums>;

}  // namespace vortree::fmm
