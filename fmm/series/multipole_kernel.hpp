#pragma once

#include <cstddef>

#include "tree/base/simd.hpp"

namespace vortree::fmm {

/// P2M, M2M and M2P of specification.hpp on multipoles stored as `order` real parts, then as many
/// imaginary parts.
/// twin    specification.hpp

inline constexpr int most_terms = 200;

struct P2mSources {
  const double *x, *y, *gamma;
  std::size_t size;
};

struct P2mFrame {
  double x, y, per_length;  // centre and 1/h
};

/// Lanes are sources; they are summed once, at the end.
inline void p2m(const P2mSources& sources, const P2mFrame& frame, int order, double* multipole) {
  Lanes sum_re[most_terms], sum_im[most_terms];
  for (int k = 0; k < order; ++k) sum_re[k] = sum_im[k] = Lanes{};
  for (std::size_t first = 0; first < sources.size; first += lane_count) {
    const LaneSet some = first_lanes(sources.size - first);
    const Lanes tx = (load(sources.x + first, some) - frame.x) * frame.per_length;
    const Lanes ty = (load(sources.y + first, some) - frame.y) * frame.per_length;
    Lanes re = load(sources.gamma + first, some), im{};
    for (int k = 0; k < order; ++k) {
      sum_re[k] += re;
      sum_im[k] += im;
      const Lanes next = re * tx - im * ty;
      im = re * ty + im * tx;
      re = next;
    }
  }
  for (int k = 0; k < order; ++k) {
    multipole[k] += sum(sum_re[k]);
    multipole[order + k] += sum(sum_im[k]);
  }
}

/// One child of a family.
struct M2mChild {
  const double* multipole;
  double x, y, shrink;  // (z_child - z_parent)/h_parent, h_child/h_parent
};

inline constexpr int family = 4;
using Family [[gnu::vector_size(32)]] = double;

/// Adds the multipoles of up to four children to their parent's; lanes are children. The binomial
/// sum is swept: with b_j = s^j c_j, the steps b_k += d b_(k-1) for k = order-1 .. m, done for
/// m = 1 .. order-1, leave sum_j binom(k, j) d^(k-j) b_j, with no power of d or binomial formed.
inline void m2m(const M2mChild* children, int count, int order, double* parent) {
  Family re[most_terms], im[most_terms], x{}, y{}, shrink{}, power{};
  for (int i = 0; i < count; ++i) {
    x[i] = children[i].x, y[i] = children[i].y, shrink[i] = children[i].shrink, power[i] = 1.0;
  }
  const double* from[family];
  for (int i = 0; i < family; ++i) from[i] = children[i < count ? i : 0].multipole;
  for (int k = 0; k < order; ++k) {
    re[k] = Family{from[0][k], from[1][k], from[2][k], from[3][k]} * power;
    im[k] = Family{from[0][order + k], from[1][order + k], from[2][order + k], from[3][order + k]} *
            power;
    power *= shrink;
  }
  for (int m = 1; m < order; ++m) {
    for (int k = order - 1; k >= m; --k) {
      re[k] += x * re[k - 1] - y * im[k - 1];
      im[k] += x * im[k - 1] + y * re[k - 1];
    }
  }
  for (int k = 0; k < order; ++k) {
    parent[k] += (re[k][0] + re[k][1]) + (re[k][2] + re[k][3]);
    parent[order + k] += (im[k][0] + im[k][1]) + (im[k][2] + im[k][3]);
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
