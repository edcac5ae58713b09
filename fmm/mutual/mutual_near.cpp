#include "fmm/mutual/mutual_near.hpp"

#include <algorithm>

namespace vortree::fmm {
namespace {

constexpr std::uint32_t line = 8;        // numbers in a line of the cache
constexpr std::size_t some_blocks = 64;  // that a cell meets: room to begin with

void prefetch(const MutualPoints& points, std::uint32_t place) {
  for (const double* column : {points.x, points.y, points.gamma}) {
    __builtin_prefetch(column + place, 0, 2);
  }
  __builtin_prefetch(points.u + place, 1, 2);
  __builtin_prefetch(points.v + place, 1, 2);
}

SingleBits fixed(const double* from, double origin, double rest, double scale) {
  const auto some = [&](const double* x) { return ((load(x) - origin) - rest) * scale; };
  return rounded(some(from), some(from + lane_count));
}

void add_scaled(double* to, Singles sums, double scale) {
  store(to, load(to) + low(sums) * scale);
  store(to + lane_count, load(to + lane_count) + high(sums) * scale);
}

}  // namespace

MutualNear::MutualNear(const DeepTree& tree, const InteractionLists& lists, const Leaves& leaves,
                       bool coarse)
    : tree_(tree), lists_(lists), leaves_(leaves), coarse_(coarse) {
  if (leaves.cored()) return;
  for (Meeting& meeting : meetings_) {
    for (Blocks* blocks : {&meeting.exact, &meeting.fixed}) {
      blocks->inside.reserve(some_blocks), blocks->outside.reserve(some_blocks);
    }
  }
}

void MutualNear::add(tree::Range leaf_run, double* u, double* v) {
  const MutualPoints points{leaves_.points.x.data(), leaves_.points.y.data(), leaves_.gamma.data(),
                            u, v};
  const auto meeting = [&](std::uint32_t leaf) -> Meeting& {
    return meetings_[leaf % meetings_.size()];
  };
  for (std::uint32_t next = leaf_run.first; next < leaf_run.last + cells_ahead; ++next) {
    if (next < leaf_run.last) arrange(next, leaf_run, points, meeting(next));
    if (next < leaf_run.first + cells_ahead) continue;
    const std::uint32_t leaf = next - cells_ahead;
    meet_exactly(leaf, meeting(leaf).exact, points);
    if (coarse_) meet_in_fixed(leaf, meeting(leaf).fixed, points);
  }
}

/// Lists what the cell will meet, and asks for its memory.
void MutualNear::arrange(std::uint32_t leaf, tree::Range leaf_run, const MutualPoints& points,
                         Meeting& meeting) {
  for (Blocks* blocks : {&meeting.exact, &meeting.fixed}) {
    blocks->inside.clear(), blocks->outside.clear();
  }
  const std::uint32_t own = tree_.childless()[leaf];
  const double widest = fixed_reach * tree_.frame(own).side;
  const auto within = [&](std::uint32_t other) {
    return other >= leaf_run.first && other < leaf_run.last;
  };
  const auto add = [&](std::uint32_t cell, std::uint32_t other, bool inside) {
    const bool fits = coarse_ && tree_.frame(cell).side <= widest;
    Blocks& blocks = fits ? meeting.fixed : meeting.exact;
    auto& places = inside ? blocks.inside : blocks.outside;
    const std::uint32_t first = leaves_.start[other], last = leaves_.start[other + 1];
    const std::uint32_t step = fits ? single_count : lane_count;
    for (std::uint32_t j = first; j < last; j += step) places.push_back(j);
    for (std::uint32_t j = first; j < last; j += line) prefetch(points, j);
  };
  lists_.for_each_ahead(own, [&](std::uint32_t cell) {
    const std::uint32_t other = lists_.leaves(cell).first;
    add(cell, other, within(other));
  });
  lists_.for_each_behind(own, [&](std::uint32_t cell) {
    const std::uint32_t other = lists_.leaves(cell).first;
    if (!within(other)) add(cell, other, false);
  });
}

void MutualNear::meet_exactly(std::uint32_t leaf, const Blocks& others,
                              const MutualPoints& points) {
  const bool itself = !coarse_ && !leaves_.in_one_place(leaf);
  if (!itself && others.inside.empty() && others.outside.empty()) return;
  const std::size_t room = padded(leaves_.size[leaf]);
  if (u_.size() < room) u_.resize(room), v_.resize(room);
  const MutualCell cell{leaves_.start[leaf], room, u_.data(), v_.data()};
  if (itself) {
    meet_itself(points, cell);
  } else {
    std::fill_n(cell.u, room, Lanes{});
    std::fill_n(cell.v, room, Lanes{});
  }
  meet_all<true>(points, cell, others.inside);
  meet_all<false>(points, cell, others.outside);
  close(points, cell);
}

void MutualNear::take(std::uint32_t leaf) {
  const std::uint32_t first = leaves_.start[leaf], size = leaves_.size[leaf];
  const CellFrame& at = tree_.frame(tree_.childless()[leaf]);
  room_.x0 = at.x, room_.y0 = at.y, room_.x_rest = at.x_rest, room_.y_rest = at.y_rest;
  room_.scale = fixed_side / at.side;
  const std::size_t whole = leaves_.start[leaf + 1] - first;
  if (room_.gamma.size() < whole) {
    room_.x.resize(whole), room_.y.resize(whole), room_.gamma.resize(whole);
    room_.u.resize(whole), room_.v.resize(whole);
  }
  for (std::uint32_t j = 0; j < whole; j += single_count) {
    const double *x = &leaves_.points.x[first + j], *y = &leaves_.points.y[first + j];
    const double* gamma = &leaves_.gamma[first + j];
    store(&room_.x[j], fixed(x, at.x, at.x_rest, room_.scale));
    store(&room_.y[j], fixed(y, at.y, at.y_rest, room_.scale));
    store(&room_.gamma[j], narrowed(load(gamma), load(gamma + lane_count)));
  }
  constexpr std::int32_t far_away = 1 << 30;
  std::fill(room_.x.begin() + size, room_.x.begin() + whole, far_away);
  std::fill(room_.u.begin() + size, room_.u.begin() + whole, Singles{});
  std::fill(room_.v.begin() + size, room_.v.begin() + whole, Singles{});
}

void MutualNear::meet_in_fixed(std::uint32_t leaf, const Blocks& others,
                               const MutualPoints& points) {
  take(leaf);
  const std::uint32_t first = leaves_.start[leaf], size = leaves_.size[leaf];
  const FixedCell cell{room_.x.data(), room_.y.data(), room_.gamma.data(),
                       room_.u.data(), room_.v.data(), size};
  if (leaves_.in_one_place(leaf)) {
    std::fill_n(cell.u, size, Singles{});
    std::fill_n(cell.v, size, Singles{});
  } else if (meet_itself(cell)) {
    for (std::uint32_t j = first; j < leaves_.start[leaf + 1]; j += single_count) {
      mend<false>(leaf, j, points);
    }
  }
  for (const std::uint32_t block : others.inside) meet_block<true>(leaf, block, points);
  for (const std::uint32_t block : others.outside) meet_block<false>(leaf, block, points);
  for (std::uint32_t i = 0; i < size; i += single_count) {
    add_scaled(points.u + first + i, side_by_side<float>(&room_.u[i]), room_.scale);
    add_scaled(points.v + first + i, side_by_side<float>(&room_.v[i]), room_.scale);
  }
}

template <bool both>
void MutualNear::meet_block(std::uint32_t leaf, std::uint32_t block, const MutualPoints& points) {
  const FixedCell cell{room_.x.data(), room_.y.data(), room_.gamma.data(),
                       room_.u.data(), room_.v.data(), leaves_.size[leaf]};
  FixedOthers others;
  others.x = fixed(points.x + block, room_.x0, room_.x_rest, room_.scale);
  others.y = fixed(points.y + block, room_.y0, room_.y_rest, room_.scale);
  others.gamma = narrowed(load(points.gamma + block), load(points.gamma + block + lane_count));
  const bool near = meet_fixed<both>(cell, others);
  if (both) {
    add_scaled(points.u + block, others.u, room_.scale);
    add_scaled(points.v + block, others.v, room_.scale);
  }
  if (near) mend<both>(leaf, block, points);
}

/// Takes back what pairs that are too near for fixed point did to each other, and adds what they
/// do.
template <bool both>
void MutualNear::mend(std::uint32_t leaf, std::uint32_t block, const MutualPoints& points) const {
  const std::uint32_t first = leaves_.start[leaf];
  const SingleBits x = fixed(points.x + block, room_.x0, room_.x_rest, room_.scale);
  const SingleBits y = fixed(points.y + block, room_.y0, room_.y_rest, room_.scale);
  for (std::uint32_t i = 0; i < leaves_.size[leaf]; ++i) {
    for (std::uint32_t lane = 0; lane < single_count; ++lane) {
      const double fixed_dx = room_.x[i] - x[lane], fixed_dy = room_.y[i] - y[lane];
      if (fixed_dx * fixed_dx + fixed_dy * fixed_dy >= fixed_near * fixed_near) continue;
      const std::uint32_t a = first + i, b = block + lane;
      const double dx = points.x[a] - points.x[b], dy = points.y[a] - points.y[b];
      const double wrong = fixed_pair_plain(fixed_dx, fixed_dy) * room_.scale;
      const double right = 1.0 / (dx * dx + (dy * dy + tiny));
      const double more_x = right * dx - wrong * fixed_dx, more_y = right * dy - wrong * fixed_dy;
      points.u[a] -= points.gamma[b] * more_y;
      points.v[a] += points.gamma[b] * more_x;
      if (both) {
        points.u[b] += points.gamma[a] * more_y;
        points.v[b] -= points.gamma[a] * more_x;
      }
    }
  }
}

}  // namespace vortree::fmm
