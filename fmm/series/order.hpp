#pragma once

#include <array>

#include "fmm/tuning.hpp"

namespace vortree::fmm {

/// How many terms of a multipole keep the promised tolerance.
///
/// A cell of radius R, seen from distance d of its expansion centre, ratio = R/d < 1: p terms leave
///
///   |error| <= (sum |gamma_j| / d) ratio^p / (1 - ratio)
///
/// if every source sat at the edge, in line with the target. Sources that fill their disk evenly
/// have a root mean square of |t|^p of (p + 1)^(-1/2) there, which is what counts where signs are
/// mixed and velocities cancel. So terms are chosen for
///
///   ratio^p / (1 - ratio) <= (p + 1)^(1/2) tolerance
///
/// The directions of the sources and the random sum of many cells' errors are left in hand: clouds
/// keep ten to twenty times below the tolerance, lattices and points in the corners of their cells
/// still below it (tests/fmm/tolerance_sweep.cpp, hard_cases.cpp).

/// Terms that keep a tolerance at a ratio in [0, 1).
[[nodiscard]] int terms_for(double tolerance, double ratio);

/// The ratio up to which so many terms keep a tolerance of the derivative of a series, which lacks
/// (p + 1)/(1 - ratio) times what the series lacks.
[[nodiscard]] double slope_ratio(double tolerance, int terms);

/// The paper's rule, one cell apart: half the diagonal over one and a half sides.
inline constexpr double one_cell_apart = 0.47140452079103168;

/// Terms by ratio, looked up.
class SeriesOrder {
 public:
  /// As many terms as each ratio needs, up to widest_ratio.
  static SeriesOrder for_tolerance(double tolerance);
  /// The same number of terms everywhere, up to a ratio, or to the paper's.
  static SeriesOrder fixed(int terms, double ratio = one_cell_apart);

  [[nodiscard]] int most() const { return most_; }
  [[nodiscard]] double squared_ratio() const { return squared_ratio_; }
  /// Terms at a squared ratio <= squared_ratio().
  [[nodiscard]] int terms(double squared) const {
    return terms_[static_cast<int>(squared * per_bin_)];
  }

 private:
  static constexpr int bins = 256;
  int most_ = 0;
  double squared_ratio_ = 0, per_bin_ = 0;
  std::array<int, bins + 1> terms_{};
};

}  // namespace vortree::fmm
