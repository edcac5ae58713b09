#include "tree/neighbors/pair_rule.hpp"

#include <algorithm>
#include <cmath>

// Compiled without fused operations: see pair_rule.hpp.
namespace vortree::tree {

namespace {

template <PairRule rule>
bool plainly_within(double dx, double dy, double ri, double rj) {
  const double r = pair_reach<rule>(ri, rj);
  return dx * dx + dy * dy < r * r;
}

}  // namespace

// The larger reach becomes a number in [1, 2). What overflows then is no neighbor, and what
// underflows is too short to matter beside it.
bool within_at_any_scale(PairRule rule, double dx, double dy, double ri, double rj) {
  const double larger = rule == PairRule::own ? ri : std::max(ri, rj);
  if (!(larger > 0)) return false;
  const int shift = -std::ilogb(larger);
  for (double* length : {&dx, &dy, &ri, &rj}) *length = std::scalbn(*length, shift);
  switch (rule) {
    case PairRule::max:
      return plainly_within<PairRule::max>(dx, dy, ri, rj);
    case PairRule::mean:
      return plainly_within<PairRule::mean>(dx, dy, ri, rj);
    default:
      return plainly_within<PairRule::own>(dx, dy, ri, rj);
  }
}

}  // namespace vortree::tree
