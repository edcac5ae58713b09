#pragma once

#include <filesystem>
#include <string>

#include "io/frames/hdf5.hpp"
#include "io/input_error.hpp"

namespace vortree::io {

/// An HDF5 file opened for reading whatever is left of it.
struct MendedFile {
  h5::Handle file;      ///< invalid if not even its list of names can be read
  std::string wound{};  ///< "is cut short: byte 10 of 20", or empty
};

/// Opens a file that may have been cut: HDF5 refuses a file shorter than its superblock
/// says, so a copy is filled up with zeros to that length, which has no name any more when it is
/// open. What the system refuses to open or read is no damage: throws std::runtime_error. throws
/// InputError if there is no such file, if it is not a regular one, or if it never
/// was HDF5
[[nodiscard]] MendedFile open_mended(const std::filesystem::path&);

}  // namespace vortree::io
