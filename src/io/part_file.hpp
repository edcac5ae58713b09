#pragma once

#include <filesystem>
#include <string>

#include "io/descriptor.hpp"
#include "io/input_error.hpp"

namespace vortree::io {

/// A file on its way to replace another: until it is put in place, in one rename, the older one
/// stays as it was, and if that never comes to pass nothing is left behind.
///
/// Where the system allows it the file has no name before; a kill leaves nothing. Else, and always
/// for libraries that open files by name, it is called `NAME.vortree.part` in the folder of the
/// file; a lock on it tells whether its writer still lives, and the next writer of the same file
/// takes the place of a dead one. Owner and rights are those of the older file. Where several may
/// write the same file at once, on several machines, each has a name of its own (Name::unique).
class PartFile {
 public:
  enum class Name { none, needed, unique };

  /// throws  InputError unless `path` may be written (require_writable without inputs)
  PartFile(const std::filesystem::path& path, Name name);
  ~PartFile();
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

  const Descriptor& descriptor() const { return file_; }
  const std::filesystem::path& path() const { return part_; }  ///< empty without a name

  enum class Until { on_disk, with_system };

  /// Until::on_disk: returns when both the file and its name would survive a power failure.
  /// throws std::runtime_error
  void put_in_place(Until until = Until::on_disk);

  /// The same, on the disk, if there is nothing of that name; of several at once one comes first.
  /// returns  false: there is something, which stays
  /// throws   std::runtime_error
  [[nodiscard]] bool put_if_free();

 private:
  void take_name();
  void take_unique_name();
  void link_to_name();
  bool link_to(const std::filesystem::path& name) const;

  std::filesystem::path named_, target_, part_;
  Descriptor file_;
};

}  // namespace vortree::io
