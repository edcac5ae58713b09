#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "fmm/near/p2p_kernel.hpp"
#include "tree/base/simd.hpp"

namespace vortree::fmm {

/// Near sums of bare vortices by Newton's third law, as mutual_kernel.hpp, for tolerances that
/// single precision meets: twice as many lanes, and division costs less than half.
///
///   u_i -= gamma_j w dy, v_i += gamma_j w dx;   u_j += gamma_i w dy, v_j -= gamma_i w dx
///   w = 1/(r^2 + 1), (dx, dy) = x_i - x_j
///
/// Places are whole numbers, so that differences of them are exact; rounded to floats these err by
/// 2^-24 of themselves, however near the pair. Lengths are 2^-28 of the side of the cell, so that
/// the 1 beside r^2 is nothing unless r = 0, and a place is wrong by 2^-29 of the side at most: too
/// much for pairs nearer than 2^-8 sides, which the caller is told of and computes again.
///
/// error   2^-22 of a pair's part, unless told
/// cost    one division of floats and eight other products and sums for two directions
/// twin    fixed_pair_plain

/// The side of a cell, and the shortest distance that is exact enough.
inline constexpr double fixed_side = 0x1p28, fixed_near = 0x1p20;
/// Cells up to so many times as wide as the cell itself, if they touch it, have places.
inline constexpr double fixed_reach = 4.0;

/// The points of a cell in whole vectors (filled up with gamma = 0 far away), and room for one
/// vector a point in each direction.
struct FixedCell {
  const std::int32_t *x, *y;
  const float* gamma;
  Singles *u, *v;
  std::size_t size;
};

/// Other points side by side, and their sums.
struct FixedOthers {
  SingleBits x, y;
  Singles gamma, u, v;
};

/// As floats above zero are ordered like their bits.
inline bool any_near(SingleBits least_r2) {
  return where((Singles)least_r2 < static_cast<float>(fixed_near * fixed_near)) != 0;
}

/// The cell and some others; both: the others gain, too. True if a pair is nearer than fixed_near.
template <bool both>
inline bool meet_fixed(const FixedCell& cell, FixedOthers& others) {
  const SingleBits x = others.x, y = others.y;
  const Singles gamma = others.gamma;
  Singles u{}, v{};
  SingleBits least = INT32_MAX - SingleBits{};
  for (std::size_t i = 0; i < cell.size; ++i) {
    const Singles dx = __builtin_convertvector(cell.x[i] - x, Singles);
    const Singles dy = __builtin_convertvector(cell.y[i] - y, Singles);
    const Singles r2 = dx * dx + (dy * dy + 1.0f);
    const Singles w = 1.0f / r2;
    least = smaller(least, (SingleBits)r2);
    const Singles upon_cell = w * gamma;
    cell.u[i] -= upon_cell * dy;
    cell.v[i] += upon_cell * dx;
    if (both) {
      const Singles upon_others = w * cell.gamma[i];
      u += upon_others * dy;
      v -= upon_others * dx;
    }
  }
  if (both) others.u = u, others.v = v;
  return any_near(least);
}

/// All points of the cell upon each other. Sets the room. True if a pair is nearer than fixed_near.
inline bool meet_itself(const FixedCell& cell) {
  constexpr std::size_t n = single_count;
  // Read from 2 n - 1 - lane on, it hides that lane; from 0 on, none.
  static constexpr struct Veil {
    std::int32_t bits[3 * n]{};
    constexpr Veil() { bits[2 * n - 1] = INT32_MAX; }
  } veil;
  SingleBits least = INT32_MAX - SingleBits{};
  for (std::size_t i = 0; i < cell.size; ++i) {
    Singles u{}, v{};
    for (std::size_t j = 0; j < cell.size; j += n) {
      const Singles dx = __builtin_convertvector(cell.x[i] - load(cell.x + j), Singles);
      const Singles dy = __builtin_convertvector(cell.y[i] - load(cell.y + j), Singles);
      const Singles r2 = dx * dx + (dy * dy + 1.0f);
      const std::size_t lane = i - j;
      least = smaller(least, (SingleBits)r2 | load(veil.bits + (lane < n ? 2 * n - 1 - lane : 0)));
      const Singles w = load(cell.gamma + j) / r2;
      u -= w * dy;
      v += w * dx;
    }
    cell.u[i] = u, cell.v[i] = v;
  }
  return any_near(least);
}

/// One pair, said plainly: the weight w.
inline double fixed_pair_plain(double dx, double dy) {
  return 1.0 / (dx * dx + dy * dy + 1.0);
}

}  // namespace vortree::fmm
