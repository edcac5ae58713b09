#pragma once

#include <span>
#include <string>
#include <string_view>

#include "io/frame_group.hpp"

namespace vortree::io {

/// The XDMF page that shows frames to ParaView and VisIt: a temporal collection of point clouds
/// with gamma, sigma, u, v and the vector velocity, at the physical times. Frames without blobs are
/// left out. `file` is the HDF5 file, relative to the page.
/// source  XDMF Model and Format, version 2
[[nodiscard]] std::string xdmf_text(std::string_view file, std::span<const FrameLabel> frames);

/// Adds one more frame to such a page, which spares looking at all the frames again.
/// Returns false, and changes nothing, if the page does not end as one made here.
[[nodiscard]] bool add_to_xdmf(std::string& page, std::string_view file, const FrameLabel& frame);

}  // namespace vortree::io
