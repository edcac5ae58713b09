#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "fmm/near/p2p_kernel.hpp"
#include "fmm/series/translation_kernel.hpp"
#include "tree/base/simd.hpp"

namespace vortree::fmm {

/// Near sums of bare vortices by Newton's third law: the distance of two points serves both.
///
///   u_i -= gamma_j w dy, v_i += gamma_j w dx;   u_j += gamma_i w dy, v_j -= gamma_i w dx
///   w = 1/r^2, (dx, dy) = x_i - x_j
///
/// Lanes are the points of other cells, in blocks of lane_count, a few of which stay in registers
/// while the points of one cell pass by. The sums of those points stay in vectors until the end.
/// Points at the same place do nothing to each other.
///
/// cost    one division and ten other operations for eight pairs
/// twin    pair_weight_plain

/// Points in whole vectors, and their sums (times 2 pi).
struct MutualPoints {
  const double *x, *y, *gamma;
  double *u, *v;
};

/// The points of one cell: the first, their number (filled up to whole vectors behind), and room
/// for one vector a point in each direction.
struct MutualCell {
  std::size_t first, size;
  Lanes *u, *v;
};

/// All points of the cell upon each other. Sets the room.
inline void meet_itself(const MutualPoints& points, const MutualCell& cell) {
  const double *x = points.x + cell.first, *y = points.y + cell.first;
  const double* gamma = points.gamma + cell.first;
  for (std::size_t i = 0; i < cell.size; ++i) {
    Lanes u{}, v{};
    for (std::size_t j = 0; j < cell.size; j += lane_count) {
      const Lanes dx = x[i] - load(x + j), dy = y[i] - load(y + j);
      const Lanes w = load(gamma + j) / (dx * dx + (dy * dy + tiny));
      u -= w * dy;
      v += w * dx;
    }
    cell.u[i] = u, cell.v[i] = v;
  }
}

/// The cell and some blocks of other cells; both: the others gain, too.
template <bool both, int blocks>
inline void meet_blocks(const MutualPoints& points, const MutualCell& cell,
                        const std::uint32_t* block) {
  Lanes x[blocks], y[blocks], gamma[blocks], u[blocks], v[blocks];
  for (int s = 0; s < blocks; ++s) {
    x[s] = load(points.x + block[s]), y[s] = load(points.y + block[s]);
    gamma[s] = load(points.gamma + block[s]);
    if (both) u[s] = load(points.u + block[s]), v[s] = load(points.v + block[s]);
  }
  const double *tx = points.x + cell.first, *ty = points.y + cell.first;
  const double* tg = points.gamma + cell.first;
  for (std::size_t i = 0; i < cell.size; ++i) {
    Lanes sum_u = cell.u[i], sum_v = cell.v[i];
    const Lanes px = fill(tx[i]), py = fill(ty[i]), pg = fill(tg[i]);
    for (int s = 0; s < blocks; ++s) {
      const Lanes dx = px - x[s], dy = py - y[s];
      const Lanes w = 1.0 / (dx * dx + (dy * dy + tiny));
      const Lanes upon = w * gamma[s];
      sum_u -= upon * dy;
      sum_v += upon * dx;
      if (both) {
        const Lanes back = w * pg;
        u[s] += back * dy;
        v[s] -= back * dx;
      }
    }
    cell.u[i] = sum_u, cell.v[i] = sum_v;
  }
  for (int s = 0; both && s < blocks; ++s) {
    store(points.u + block[s], u[s]), store(points.v + block[s], v[s]);
  }
}

template <bool both>
inline void meet_all(const MutualPoints& points, const MutualCell& cell,
                     std::span<const std::uint32_t> block) {
  std::size_t k = 0;
  if constexpr (registers >= 32) {  // as many as three blocks fill
    for (; block.size() - k >= 5 || block.size() - k == 3; k += 3) {
      meet_blocks<both, 3>(points, cell, &block[k]);
    }
  }
  for (; block.size() - k >= 2; k += 2) meet_blocks<both, 2>(points, cell, &block[k]);
  if (k < block.size()) meet_blocks<both, 1>(points, cell, &block[k]);
}

/// Adds what the room holds to the sums of the cell.
inline void close(const MutualPoints& points, const MutualCell& cell) {
  for (std::size_t i = 0; i < cell.size; i += lane_count) {
    Lanes u[lane_count], v[lane_count];
    for (int k = 0; k < lane_count; ++k) u[k] = cell.u[i + k], v[k] = cell.v[i + k];
    transpose<double>(u);
    transpose<double>(v);
    for (int k = 1; k < lane_count; ++k) u[0] += u[k], v[0] += v[k];
    double *to_u = points.u + cell.first + i, *to_v = points.v + cell.first + i;
    store(to_u, load(to_u) + u[0]);
    store(to_v, load(to_v) + v[0]);
  }
}

}  // namespace vortree::fmm
