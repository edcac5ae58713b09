#pragma once

#include <filesystem>
#include <memory>

#include "io/arrays/array_file.hpp"

namespace vortree::io {

/// The datasets at the root of an HDF5 file.
///
/// throws  InputError, with the file: no such file, not HDF5, damaged, the frames of a run; its
///         members h5::Failure as hdf5_inside.hpp says
[[nodiscard]] std::unique_ptr<ArrayFile> open_hdf5(const std::filesystem::path&);

}  // namespace vortree::io
