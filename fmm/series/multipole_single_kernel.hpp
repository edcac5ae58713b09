#pragma once

#include "tree/base/simd.hpp"

namespace vortree::fmm {

/// M2P in single precision: targets and centre in one frame of floats, in lengths near the extent
/// of the targets. The sums are added up in double.
///
/// error   2^-24 times a few, relative to (sum |gamma_j|)/distance
/// twin    m2p_rows of multipole_kernel.hpp
struct M2pSingleSource {
  float x, y, h;         // centre and length, in the frame
  double per_length;     // 1/h in Units
  const float *re, *im;  // coefficients
  int terms;
};

template <int rows>
inline void m2p_single_rows(const M2pSingleSource& source, const float* x, const float* y,
                            double* u, double* v) {
  Singles wx[rows], wy[rows], re[rows], im[rows];
  for (int i = 0; i < rows; ++i) {
    const Singles dx = load(x + single_count * i) - source.x;
    const Singles dy = load(y + single_count * i) - source.y;
    const Singles inverse = source.h / (dx * dx + dy * dy);
    wx[i] = dx * inverse;
    wy[i] = -dy * inverse;
    re[i] = fill(source.re[source.terms - 1]);
    im[i] = fill(source.im[source.terms - 1]);
  }
  for (int k = source.terms - 2; k >= 0; --k) {
    for (int i = 0; i < rows; ++i) {
      const Singles next = wx[i] * re[i] + (source.re[k] - wy[i] * im[i]);
      im[i] = wx[i] * im[i] + (source.im[k] + wy[i] * re[i]);
      re[i] = next;
    }
  }
  for (int i = 0; i < rows; ++i) {
    const Singles part_u = wx[i] * im[i] + wy[i] * re[i];
    const Singles part_v = wx[i] * re[i] - wy[i] * im[i];
    double *to_u = u + single_count * i, *to_v = v + single_count * i;
    store(to_u, load(to_u) + source.per_length * low(part_u));
    store(to_u + lane_count, load(to_u + lane_count) + source.per_length * high(part_u));
    store(to_v, load(to_v) + source.per_length * low(part_v));
    store(to_v + lane_count, load(to_v + lane_count) + source.per_length * high(part_v));
  }
}

}  // namespace vortree::fmm
