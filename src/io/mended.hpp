#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include "io/hdf5.hpp"
#include "io/input_error.hpp"

namespace vortree::io {

/// Removes the file when it goes.
class TemporaryFile {
 public:
  TemporaryFile() = default;
  explicit TemporaryFile(std::filesystem::path path) : path_(std::move(path)) {}
  TemporaryFile(TemporaryFile&& other) noexcept { path_.swap(other.path_); }
  TemporaryFile& operator=(TemporaryFile&& other) noexcept {
    path_.swap(other.path_);
    return *this;
  }
  ~TemporaryFile();

 private:
  std::filesystem::path path_;
};

/// An HDF5 file opened for reading whatever is left of it.
struct MendedFile {
  TemporaryFile copy;   ///< holds the mended copy of a cut file; declared first: removed last
  h5::Handle file;      ///< invalid if not even its list of names can be read
  std::string wound{};  ///< "is cut short: byte 10 of 20", or empty
};

/// Opens a file that may have been cut: HDF5 refuses a file shorter than its superblock
/// says, so a copy is filled up with zeros to that length. throws  InputError if there is no such
/// file or if it never was HDF5
[[nodiscard]] MendedFile open_mended(const std::filesystem::path&);

}  // namespace vortree::io
