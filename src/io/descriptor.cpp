#include "io/descriptor.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace vortree::io {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& named, const char* what) {
  throw std::runtime_error(
      fmt::format("{} cannot be {}: {}", named.string(), what, std::strerror(errno)));
}

/// Some file systems know no forcing; what cannot be asked for is no failure.
bool unknown_here() {
  return errno == EINVAL || errno == ENOSYS || errno == EOPNOTSUPP;
}

}  // namespace

Descriptor::~Descriptor() {
  if (number_ >= 0) ::close(number_);
}

void write_whole(const Descriptor& file, std::string_view text,
                 const std::filesystem::path& named) {
  while (!text.empty()) {
    const ssize_t written = ::write(file, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) refuse(named, "written");
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

void force(const Descriptor& file, const std::filesystem::path& named) {
  if (::fsync(file) != 0 && !unknown_here()) refuse(named, "forced to the disk");
}

void force_folder(const std::filesystem::path& folder) {
  const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened < 0 && errno == EACCES) return;  // may be written but not read
  if (opened < 0) refuse(folder, "opened");
  force(opened, folder);
}

}  // namespace vortree::io
