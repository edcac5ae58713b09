#pragma once

namespace vortree::vortex {

/// What a blob wider than sigma_max becomes away from the wall: a ring of children
/// (split_wide.hpp), or nodes of a lattice (lay_onto_lattice.hpp). Beside the wall it is a cross
/// of children with either.
enum class SplitScheme { ring, lattice };

}  // namespace vortree::vortex
