#pragma once

namespace vortree::vortex {

/// What a blob wider than sigma_max becomes: a ring of children, beside the wall a cross of them
/// (split_wide.hpp), or nodes of a lattice (lattice/laying.hpp).
enum class SplitScheme { ring, lattice };

}  // namespace vortree::vortex
