#pragma once

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

/// The rule itself, to the last bit: every list of this library holds exactly the pairs for which
///
///   dx dx + dy dy < r r,   r = pair_reach(r_i, r_j),   dx = x_j - x_i,   dy = y_j - y_i,
///
/// each operation rounded once, in doubles. For the compiler to keep to that, code that calls this
/// is compiled without fused operations: -ffp-contract=off.
template <PairRule rule>
[[nodiscard]] constexpr bool within(double dx, double dy, double ri, double rj) {
  const double r = pair_reach<rule>(ri, rj);
  return dx * dx + dy * dy < r * r;
}

}  // namespace vortree::tree
