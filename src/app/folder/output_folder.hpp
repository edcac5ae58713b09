#pragma once

#include <filesystem>

#include "io/descriptor.hpp"

namespace vortree::app {

/// A folder that this process alone fills, as long as the value lives; others may read it.
///
/// Held by flock() on the folder itself, so that nothing is left of it, not even after a kill.
/// Where the file system knows no such lock, that is said on standard error and the work goes on. A
/// folder that was made here, and into which nothing came, is removed again.
class OutputFolder {
 public:
  /// Made if need be.
  /// throws  io::InputError if it cannot be made, as where a link leads to nothing, or if another
  ///         process fills it (which one)
  explicit OutputFolder(const std::filesystem::path&);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  bool made_ = false;
  io::Descriptor folder_;
};

}  // namespace vortree::app
