#include "tree/neighbors/exact_distance.hpp"

#include <algorithm>

// Compiled without fused operations: see pair_rule.hpp.
namespace vortree::tree {

namespace {

template <PairRule rule>
unsigned test_few(const SortedParticles& placed, std::uint32_t particle,
                  std::span<const std::int32_t> others) {
  unsigned passed = 0;
  for (std::size_t k = 0; k < others.size(); ++k) {
    const auto j = static_cast<std::size_t>(others[k]);
    const bool is_near =
        within<rule>(placed.x[j] - placed.x[particle], placed.y[j] - placed.y[particle],
                     placed.reach[particle], placed.reach[j]);
    passed |= static_cast<unsigned>(is_near) << k;
  }
  return passed;
}

// The same as test_few where squares neither overflow nor underflow, a register full at a time.
template <PairRule rule>
std::int64_t test_all(const SortedParticles& placed, std::uint32_t particle,
                      std::span<const std::int32_t> others, kernel::Hits* hits) {
  const double x = placed.x[particle], y = placed.y[particle], reach = placed.reach[particle];
  std::int64_t count = 0;
  for (std::size_t first = 0; first < others.size(); first += single_count) {
    const std::size_t last = std::min(others.size(), first + single_count);
    unsigned passed = 0;
    bool ordinary = true;
    for (std::size_t k = first; k < last; ++k) {
      const auto j = static_cast<std::size_t>(others[k]);
      const double dx = placed.x[j] - x, dy = placed.y[j] - y;
      const double r = pair_reach<rule>(reach, placed.reach[j]), limit = r * r;
      ordinary &= limit >= least_square && limit <= largest_square;
      passed |= static_cast<unsigned>(dx * dx + dy * dy < limit) << (k - first);
    }
    if (!ordinary) passed = test_few<rule>(placed, particle, others.subspan(first, last - first));
    *hits++ = static_cast<kernel::Hits>(passed);
    count += std::popcount(passed);
  }
  return count;
}

}  // namespace

std::int64_t exact_test(const SortedParticles& placed, PairRule rule, std::uint32_t particle,
                        std::span<const std::int32_t> others, kernel::Hits* hits) {
  switch (rule) {
    case PairRule::max:
      return test_all<PairRule::max>(placed, particle, others, hits);
    case PairRule::mean:
      return test_all<PairRule::mean>(placed, particle, others, hits);
    default:
      return test_all<PairRule::own>(placed, particle, others, hits);
  }
}

}  // namespace vortree::tree
