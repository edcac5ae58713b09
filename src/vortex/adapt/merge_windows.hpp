#pragma once

#include "vortex/adapt/adaptation.hpp"
#include "vortex/adapt/merge_close.hpp"

namespace vortree::vortex {

/// Merges blobs within windows: up to 32 like signed neighbors on a Hilbert curve through a tile of
/// the plane, of which nothing but cache is read while they merge. Merges what merge_close.hpp
/// allows but for pairs that are parted by a window's border; another `shift` has other borders.
///
/// shift   of the tiles, in sides of a tile
///
/// Blobs come out sorted by sign, tile and place along the curve. Circulations below 0 are looked
/// at in the mirror of the x axis: the mirror image of a flow has mirrored windows. cost O(blobs)
void merge_in_windows(AdaptedBlobs& adapted, const Merging& merging, double shift);

}  // namespace vortree::vortex
