#pragma once

#include <filesystem>

#include "io/descriptor.hpp"

namespace vortree::app {

/// A folder that this process fills, as long as the value lives, alone or beside others that share
/// it; others may read it.
///
/// Held by flock() on the folder itself, so that nothing is left of it, not even after a kill.
/// Where the file system knows no such lock, that is said on standard error and the work goes on. A
/// folder that was made here, and into which nothing came, is removed again.
class OutputFolder {
 public:
  enum class Use { alone, shared };

  /// Made if need be.
  /// throws  io::InputError if it cannot be made, as where a link leads to nothing, or if another
  ///         process fills it (which one); of those that share it none does to another
  explicit OutputFolder(const std::filesystem::path&, Use use = Use::alone);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  bool made_ = false;
  io::Descriptor folder_;
};

/// Whether a process of this machine fills the folder: found without a lock of our own, which would
/// be in the way of one that begins.
[[nodiscard]] bool being_filled(const std::filesystem::path& folder);

}  // namespace vortree::app
