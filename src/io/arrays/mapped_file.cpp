#include "io/arrays/mapped_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>

#include "io/descriptor.hpp"
#include "io/files.hpp"

namespace vortree::io {

MappedFile::MappedFile(const std::filesystem::path& path) {
  require_regular_file(path);
  const auto refuse_unless = [&](bool good) {
    if (!good)
      throw InputError(fmt::format("{} cannot be read: {}", path.string(), std::strerror(errno)));
  };
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat found = {};
  refuse_unless(file >= 0 && ::fstat(file, &found) == 0);
  length_ = static_cast<std::size_t>(found.st_size);
  if (length_ == 0) return;  // nothing is no place in memory
  void* first = ::mmap(nullptr, length_, PROT_READ, MAP_PRIVATE, file, 0);
  refuse_unless(first != MAP_FAILED);
  first_ = first;
}

MappedFile::~MappedFile() {
  if (first_ != nullptr) ::munmap(first_, length_);
}

}  // namespace vortree::io
