#pragma once

#include <cstdint>
#include <span>

#include "tree/neighbors/candidate_kernel.hpp"
#include "tree/neighbors/pair_rule.hpp"
#include "tree/neighbors/sorted_particles.hpp"

namespace vortree::tree {

/// Tests the particle at position `particle` against those at `others`, in doubles, as `within`
/// says.
///
/// hits     a set of lanes for each register full of others; overwritten
/// returns  how many passed
std::int64_t exact_test(const SortedParticles& placed, PairRule rule, std::uint32_t particle,
                        std::span<const std::int32_t> others, kernel::Hits* hits);

}  // namespace vortree::tree
