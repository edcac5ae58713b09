#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "tree/neighbors/neighbors.hpp"

/// What lists of neighbors must hold. To be compiled without fused operations: see
/// tree/neighbors/pair_rule.hpp.
namespace vortree::test {

using Pairs = std::vector<std::pair<std::int32_t, std::int32_t>>;

/// Is j a neighbor of i?
inline bool is_neighbor(tree::Points p, std::span<const double> reach, tree::PairRule rule,
                        std::size_t i, std::size_t j) {
  const double dx = p.x[j] - p.x[i], dy = p.y[j] - p.y[i];
  const double r = rule == tree::PairRule::max    ? std::max(reach[i], reach[j])
                   : rule == tree::PairRule::mean ? 0.5 * (reach[i] + reach[j])
                                                  : reach[i];
  return dx * dx + dy * dy < r * r;
}

/// Every (i, j) with j a neighbor of i, in order.
inline Pairs all_pairs(tree::Points p, std::span<const double> reach, tree::PairRule rule) {
  Pairs pairs;
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < p.size(); ++j) {
      if (j != i && is_neighbor(p, reach, rule, i, j)) pairs.emplace_back(i, j);
    }
  }
  return pairs;
}

/// The pairs of a list in order; both directions if it holds each once.
inline Pairs pairs_of(const tree::PairList& rows, tree::Listing listing) {
  Pairs pairs;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (const std::int32_t j : rows.row(i)) {
      pairs.emplace_back(i, j);
      if (listing == tree::Listing::once) pairs.emplace_back(j, i);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace vortree::test
