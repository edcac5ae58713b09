#pragma once

#include <filesystem>

#include "io/frames/frames.hpp"
#include "io/frames/hdf5.hpp"

namespace vortree::io {

/// An empty frames file with the attributes of the run and the units of the columns.
void write_empty_frames(const std::filesystem::path&, const RunInfo&, const flow::Columns&);

/// throws h5::Failure if an attribute is missing or damaged
[[nodiscard]] RunInfo read_run_info(hid_t file);

/// Whether the file's checksum is that of these attributes; files of earlier versions have none.
[[nodiscard]] bool agrees_with_checksum(hid_t file, const RunInfo&);

}  // namespace vortree::io
