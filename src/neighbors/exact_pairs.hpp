#pragma once

#include <cstddef>

#include "neighbors/methods.hpp"
#include "tree/neighbors/pair_rule.hpp"

/// The test of a pair and who keeps it, for methods that go from particle to particle. Their
/// sources are compiled without fused operations: see tree/neighbors/pair_rule.hpp.
namespace vortree::neighbors {

/// Calls work with the rule as a constant.
template <class Work>
decltype(auto) with_rule(tree::PairRule rule, Work&& work) {
  using enum tree::PairRule;
  switch (rule) {
    case max:
      return work.template operator()<max>();
    case mean:
      return work.template operator()<mean>();
    default:
      return work.template operator()<own>();
  }
}

template <tree::PairRule rule>
bool is_pair(const NeighborJob& job, std::size_t i, std::size_t j) {
  return tree::within<rule>(job.points.x[j] - job.points.x[i], job.points.y[j] - job.points.y[i],
                            job.reach[i], job.reach[j]);
}

/// Does the row of i hold the pair (i, j), if each stands in one row only? In that of the wider
/// reach, or of the smaller number.
inline bool keeps(const NeighborJob& job, std::size_t i, std::size_t j) {
  return job.reach[i] != job.reach[j] ? job.reach[i] > job.reach[j] : i < j;
}

}  // namespace vortree::neighbors
