#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/frames/group.hpp"

namespace vortree::io {

/// The XDMF page that shows frames to ParaView and meshio: a temporal collection of point clouds
/// with all columns and, of u and v, the vector velocity, at the physical times. Frames without
/// particles are left out. `file` is the HDF5 file, relative to the page. Positions and velocities
/// are named as rows of three, and the vertices as a list, for that is all that every reader takes.
/// source  XDMF Model and Format, version 3
[[nodiscard]] std::string xdmf_text(std::string_view file, std::span<const FrameLabel> frames);

/// Adds one more frame to such a page, which spares looking at all the frames again.
/// Returns false, and changes nothing, if the page does not end as one made here.
[[nodiscard]] bool add_to_xdmf(std::string& page, std::string_view file, const FrameLabel& frame);

/// A field on a grid of rows (y) and columns (x), under its name in the HDF5 file, and what has
/// values there.
struct FieldLabel {
  std::string name;
  double time;
  std::size_t rows, columns;
  std::vector<std::string> values{"u", "v", "omega"};
};

/// The same for fields: a temporal collection of rectilinear grids with their values.
[[nodiscard]] std::string fields_xdmf_text(std::string_view file,
                                           std::span<const FieldLabel> fields);

}  // namespace vortree::io
