#include "fmm/mutual_near.hpp"

#include <algorithm>

namespace vortree::fmm {
namespace {

constexpr std::uint32_t in_advance = 4;  // cells to ask memory for
constexpr std::uint32_t line = 8;        // numbers in a line of the cache

/// `use(first)` for the blocks of a childless cell.
template <class Use>
void for_each_block(const Lists& lists, const Leaves& leaves, std::uint32_t cell,
                    std::uint32_t step, Use use) {
  const std::uint32_t leaf = lists.leaves(cell).first;
  for (std::uint32_t j = leaves.start[leaf]; j < leaves.start[leaf + 1]; j += step) use(j);
}

void prefetch(const MutualPoints& points, std::uint32_t block) {
  for (const double* column : {points.x, points.y, points.gamma}) {
    __builtin_prefetch(column + block, 0, 2);
  }
  __builtin_prefetch(points.u + block, 1, 2);
  __builtin_prefetch(points.v + block, 1, 2);
}

SingleBits fixed(const double* from, double origin, double rest, double scale) {
  const auto some = [&](const double* x) { return ((load(x) - origin) - rest) * scale; };
  return rounded(some(from), some(from + lane_count));
}

void add_scaled(double* to, Singles sums, double scale) {
  store(to, load(to) + low(sums) * scale);
  store(to + lane_count, load(to + lane_count) + high(sums) * scale);
}

/// The sum over the lanes of each of some vectors.
Singles side_by_side(const Singles* sums) {
  Singles part[single_count];
  std::copy_n(sums, single_count, part);
  transpose<float>(part);
  for (int width = single_count / 2; width > 0; width /= 2) {
    for (int k = 0; k < width; ++k) part[k] += part[k + width];
  }
  return part[0];
}

}  // namespace

void MutualNear::add(tree::Range slab, double* u, double* v) {
  const MutualPoints points{leaves_.points.x.data(), leaves_.points.y.data(), leaves_.gamma.data(),
                            u, v};
  const auto childless = tree_.childless();
  for (std::uint32_t leaf = slab.first; leaf < slab.last; ++leaf) {
    if (leaf + in_advance < slab.last) {
      lists_.for_each_ahead(childless[leaf + in_advance], [&](std::uint32_t cell) {
        for_each_block(lists_, leaves_, cell, line,
                       [&](std::uint32_t j) { prefetch(points, j); });
      });
    }
    gather(childless[leaf], slab);
    meet_exactly(leaf, points);
    if (coarse_) meet_in_fixed(leaf, points);
  }
}

/// All that the cell meets, but itself.
void MutualNear::gather(std::uint32_t own, tree::Range slab) {
  exact_.clear(), fixed_.clear();
  const double widest = fixed_reach * tree_.frame(own).side;
  const auto within = [&](std::uint32_t cell) {
    const std::uint32_t leaf = lists_.leaves(cell).first;
    return leaf >= slab.first && leaf < slab.last;
  };
  const auto add = [&](std::uint32_t cell, bool inside) {
    const bool fits = coarse_ && tree_.frame(cell).side <= widest;
    Blocks& blocks = fits ? fixed_ : exact_;
    auto& places = inside ? blocks.inside : blocks.outside;
    for_each_block(lists_, leaves_, cell, fits ? single_count : lane_count,
                   [&](std::uint32_t j) { places.push_back(j); });
  };
  lists_.for_each_ahead(own, [&](std::uint32_t cell) { add(cell, within(cell)); });
  lists_.for_each_behind(own, [&](std::uint32_t cell) {
    if (!within(cell)) add(cell, false);
  });
}

void MutualNear::meet_exactly(std::uint32_t leaf, const MutualPoints& points) {
  const bool itself = !coarse_ && !leaves_.in_one_place(leaf);
  if (!itself && exact_.inside.empty() && exact_.outside.empty()) return;
  const std::size_t room = padded(leaves_.size[leaf]);
  if (u_.size() < room) u_.resize(room), v_.resize(room);
  const MutualCell cell{leaves_.start[leaf], room, u_.data(), v_.data()};
  if (itself) {
    meet_itself(points, cell);
  } else {
    std::fill_n(cell.u, room, Lanes{});
    std::fill_n(cell.v, room, Lanes{});
  }
  meet_all<true>(points, cell, exact_.inside);
  meet_all<false>(points, cell, exact_.outside);
  close(points, cell);
}

void MutualNear::take(std::uint32_t leaf) {
  const std::uint32_t first = leaves_.start[leaf], size = leaves_.size[leaf];
  const Frame& at = tree_.frame(tree_.childless()[leaf]);
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

void MutualNear::meet_in_fixed(std::uint32_t leaf, const MutualPoints& points) {
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
  for (const std::uint32_t block : fixed_.inside) meet_block<true>(leaf, block, points);
  for (const std::uint32_t block : fixed_.outside) meet_block<false>(leaf, block, points);
  for (std::uint32_t i = 0; i < size; i += single_count) {
    add_scaled(points.u + first + i, side_by_side(&room_.u[i]), room_.scale);
    add_scaled(points.v + first + i, side_by_side(&room_.v[i]), room_.scale);
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
