#pragma once

#include "tree/neighbors/pair_list.hpp"

namespace vortree::neighbors {

/// Puts the neighbors of every particle, each there once, in the order of their numbers: lists by
/// any method are equal then, and so are the bits of sums over them.
void sort_rows(tree::PairList& rows);

}  // namespace vortree::neighbors
