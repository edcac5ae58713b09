#pragma once

#include <cstddef>

#include "fmm/lanes.hpp"

namespace vortree::fmm {

/// P2M, M2M and M2P of operators.hpp on multipoles stored as `order` real parts, then as many
/// imaginary parts.
/// twin    operators.hpp

inline constexpr int most_terms = 200;

struct P2mSources {
  const double *x, *y, *gamma;
  std::size_t size;
};

struct P2mFrame {
  double x, y, per_length;  // centre and 1/h
};

/// Lanes are sources.
inline void p2m(const P2mSources& sources, const P2mFrame& frame, int order, double* multipole) {
  for (std::size_t first = 0; first < sources.size; first += lane_count) {
    Lanes tx{}, ty{}, re{}, im{};
    for (std::size_t i = 0; i < lane_count && first + i < sources.size; ++i) {
      tx[i] = (sources.x[first + i] - frame.x) * frame.per_length;
      ty[i] = (sources.y[first + i] - frame.y) * frame.per_length;
      re[i] = sources.gamma[first + i];
    }
    for (int k = 0; k < order; ++k) {
      multipole[k] += sum(re);
      multipole[order + k] += sum(im);
      const Lanes next = re * tx - im * ty;
      im = re * ty + im * tx;
      re = next;
    }
  }
}

struct M2mShift {
  double x, y, shrink;  // (z_child - z_parent)/h_parent, h_child/h_parent
};

/// A shift of the argument of the polynomial sum_k c_k t^k/k!-like powers: with b_j = s^j c_j, the
/// sweeps b_k += d b_(k-1) for k = order-1 .. m, m = 1 .. order-1, leave sum_j binom(k, j) d^(k-j)
/// b_j.
inline void m2m(const double* child, const M2mShift& shift, int order, double* parent) {
  double re[most_terms], im[most_terms];
  double power = 1.0;
  for (int k = 0; k < order; ++k, power *= shift.shrink) {
    re[k] = child[k] * power;
    im[k] = child[order + k] * power;
  }
  for (int m = 1; m < order; ++m) {
    for (int k = order - 1; k >= m; --k) {
      re[k] += shift.x * re[k - 1] - shift.y * im[k - 1];
      im[k] += shift.x * im[k - 1] + shift.y * re[k - 1];
    }
  }
  for (int k = 0; k < order; ++k) {
    parent[k] += re[k];
    parent[order + k] += im[k];
  }
}

struct M2pSource {
  double x, y, h;         // centre and length
  const double *re, *im;  // coefficients
  int terms;
};

/// Adds velocities (times 2 pi) at rows * 8 targets; lanes are targets.
template <int rows>
inline void m2p_rows(const M2pSource& source, const double* x, const double* y, double* u,
                     double* v) {
  Lanes wx[rows], wy[rows], re[rows], im[rows];
  for (int i = 0; i < rows; ++i) {
    const Lanes dx = load(x + lane_count * i) - source.x, dy = load(y + lane_count * i) - source.y;
    const Lanes inverse = source.h / (dx * dx + dy * dy);
    wx[i] = dx * inverse;
    wy[i] = -dy * inverse;
    re[i] = fill(source.re[source.terms - 1]);
    im[i] = fill(source.im[source.terms - 1]);
  }
  for (int k = source.terms - 2; k >= 0; --k) {
    for (int i = 0; i < rows; ++i) {
      const Lanes next = wx[i] * re[i] + (source.re[k] - wy[i] * im[i]);
      im[i] = wx[i] * im[i] + (source.im[k] + wy[i] * re[i]);
      re[i] = next;
    }
  }
  const double per_length = 1.0 / source.h;
  for (int i = 0; i < rows; ++i) {
    const Lanes scaled_x = wx[i] * per_length, scaled_y = wy[i] * per_length;
    store(u + lane_count * i, load(u + lane_count * i) + scaled_x * im[i] + scaled_y * re[i]);
    store(v + lane_count * i, load(v + lane_count * i) + scaled_x * re[i] - scaled_y * im[i]);
  }
}

}  // namespace vortree::fmm
