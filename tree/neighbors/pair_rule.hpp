#pragma once

#include <limits>

namespace vortree::tree {

/// When particle j is a neighbor of particle i, by the reaches r_i and r_j (radii of the kernels'
/// supports).
///
///   max    |x_i - x_j| < max(r_i, r_j)       symmetric: each sees whom it reaches or is reached by
///   mean   |x_i - x_j| < (r_i + r_j) / 2     symmetric
///   own    |x_i - x_j| < r_i                 not symmetric: "gather"
enum class PairRule { max, mean, own };

/// The reach of a pair.
template <PairRule rule>
[[nodiscard]] constexpr double pair_reach(double ri, double rj) {
  if constexpr (rule == PairRule::max) return ri < rj ? rj : ri;
  if constexpr (rule == PairRule::mean) return 0.5 * (ri + rj);
  return ri;
}

/// Where the square of a pair's reach lies between these, doubles neither overflow nor underflow in
/// a way that matters: what is lost of dx dx or dy dy is below 2^-122 of it.
inline constexpr double least_square = 0x1p-900,
                        largest_square = std::numeric_limits<double>::max();

/// `within` for lengths of any size: all are divided by the power of two next to the larger reach.
[[nodiscard]] bool within_at_any_scale(PairRule rule, double dx, double dy, double ri, double rj);

/// The rule itself, to the last bit: every list of this library holds exactly the pairs for which
///
///   dx dx + dy dy < r r,   r = pair_reach(r_i, r_j),   dx = x_j - x_i,   dy = y_j - y_i,
///
/// each operation rounded once to the 53 bits of a double, as if exponents had no bounds: lengths
/// of 1e-170 or 1e170 are compared as those of 1 are. Coordinates are at most largest_coordinate in
/// magnitude (points.hpp), reaches anything from 0 to the largest double.
///
/// Rounding is monotone, so |x_j - x_i| < r and |y_j - y_i| < r hold for every pair without any
/// rounding at all: whoever seeks pairs in squares and cells of side r needs no margin for the
/// rule.
///
/// For the compiler to keep to that, code that calls this is compiled without fused operations:
/// -ffp-contract=off.
template <PairRule rule>
[[nodiscard]] inline bool within(double dx, double dy, double ri, double rj) {
  const double r = pair_reach<rule>(ri, rj), limit = r * r;
  if (limit >= least_square && limit <= largest_square) return dx * dx + dy * dy < limit;
  return within_at_any_scale(rule, dx, dy, ri, rj);
}

}  // namespace vortree::tree
