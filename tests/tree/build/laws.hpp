#pragma once

#include <string>

#include "tree/build/quadtree.hpp"
#include "tree/build/split_rule.hpp"
#include "tree/order/points.hpp"

namespace vortree::test {

/// The first law of a quadtree that this one breaks, in words; empty if it keeps them all.
std::string broken_law(const tree::Quadtree& tree, const tree::SplitRule& must_split,
                       tree::Points points);

}  // namespace vortree::test
