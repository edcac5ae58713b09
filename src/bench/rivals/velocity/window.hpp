#pragma once

#include <vector>

#include "tree/base/simd.hpp"

namespace vortree::bench {

/// Kaiser-Bessel window, by which points are spread onto a grid and read off it. Lengths in grid
/// spacings:
///
///   phi(x) = I0(shape sqrt(1 - (2x/width)^2)) / I0(shape),   |x| <= width/2
///
/// width      grid lines that a point touches, 2 .. most_width
/// accuracy   to which the weights are computed, of phi(0) = 1
/// source     Potts & Steidl, SIAM J. Sci. Comput. 24 (2003)
class Window {
 public:
  static constexpr int lanes = lane_count, most_width = 16;

  Window(int width, double shape, double accuracy);

  [[nodiscard]] int width() const { return width_; }
  /// Vectors of `lanes` values that hold the weights of one direction.
  [[nodiscard]] int vectors() const { return (width_ + lanes - 1) / lanes; }

  /// Weights on the grid lines first, first + 1, ... about a point at `first + width/2 - t`,
  /// 0 <= t <= 1: phi(j + t - width/2). Past `width` they are zero.
  template <int vectors>
  void weigh(double t, Lanes (&weights)[vectors]) const {
    const double s = 2.0 * t - 1.0;
    const double* term = terms_.data();
#pragma GCC unroll 4
    for (int j = 0; j < vectors; ++j) weights[j] = load(term + j * lanes);
    for (int k = 1; k <= degree_; ++k) {
      term += vectors * lanes;
#pragma GCC unroll 4
      for (int j = 0; j < vectors; ++j) weights[j] = weights[j] * s + load(term + j * lanes);
    }
  }

  /// Fourier transform, integral phi(x) cos(xi x) dx.
  [[nodiscard]] double transform(double xi) const;

 private:
  int width_, degree_;
  double shape_, scale_;
  std::vector<double> terms_;  // of every weight's polynomial in 2t - 1, the highest power first
};

}  // namespace vortree::bench
