#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fmm/losses/expected.hpp"

namespace vortree::fmm {

/// The square of what single precision rounds off, of all: the last bit of places, products, sums.
inline constexpr double float_rounding2 = 0x1p-48;

/// What near sums are expected to lose at a target, of f, a derivative of it (1) or its integral
/// (-1).
///
/// own, squares             sum gamma^2 of its cell, of all sources
/// side2                    the squared side of its cell
/// own_core                 the least squared core in its cell
/// least_core, widest_core  of all sources; 0 if all are bare
/// points                   in its cell
struct NearErrors {
  double own = 0.0, squares = 0.0, side2 = 1.0;
  double own_core = 0.0, least_core = 0.0, widest_core = 0.0;
  double points = 1.0;

  /// In floats. Bare pairs err by the last bit of themselves, for places are in fixed point; on a
  /// line they are as near as side/points. With cores, places in the frame of a cell, wrong by an
  /// eps of its side h, move what a core S turns by eps h/S, and by eps h/r^2 beyond. What has too
  /// narrow cores for that is summed in doubles (MutualCores, NearSources).
  [[nodiscard]] Lost rounding(int derivative) const {
    if (widest_core == 0.0) return {0.0, float_rounding2 * points * squares / side2};
    if (side2 > hidden_in_floats * own_core) return {};
    const bool cored = side2 <= cored_in_floats * own_core;
    const double core = cored ? shown() : faded_reach2 * own_core;
    const double moved = std::min(2 * std::numbers::pi / core, side2 / (core * core));
    const double met = cored && side2 > all_in_floats * core ? own : squares;
    const double error = float_rounding2 / 2 * met * moved;
    return {0.0, derivative > 0 ? error / core : error};
  }
  /// Cores count as nothing from r^2 = reach2 S on: exp(-reach2) of what a pair there adds, half
  /// of it met as if it counted.
  [[nodiscard]] Lost faded(double reach2, int derivative) const {
    if (widest_core == 0.0) return {};
    const double density = squares / (9 * side2 + 4 * reach2 * least_core);
    double error = std::exp(-2 * reach2) * std::numbers::pi / (8 * reach2) * density;
    if (derivative > 0) error *= 4 * (1 + reach2) * (1 + reach2) / (reach2 * shown());
    if (derivative < 0) error *= 4 * widest_core / reach2;
    return {error, 0.0};
  }

 private:
  /// Squared sides over the least core up to which all, those of the cell, and those beyond the
  /// reach of their cores are summed in floats.
  static constexpr double all_in_floats = 256, cored_in_floats = 1024, hidden_in_floats = 16384;
  static constexpr double faded_reach2 = 10;

  /// Narrower ones are as good as bare.
  [[nodiscard]] double shown() const { return std::max(least_core, side2 / cored_in_floats); }
};

}  // namespace vortree::fmm
