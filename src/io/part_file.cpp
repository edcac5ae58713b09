#include "io/part_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <stdexcept>
#include <string_view>

#include "io/files.hpp"

namespace vortree::io {
namespace {

namespace fs = std::filesystem;

/// Beside the target: the name that all its writers try first, or one that is this process's own. A
/// long name is shortened: the system allows 255 bytes.
fs::path part_name(const fs::path& target, bool own) {
  std::string name = target.filename().string();
  const std::string ending = own ? fmt::format(".{}.vortree.part", ::getpid()) : ".vortree.part";
  if (constexpr std::size_t longest = 255; name.size() + ending.size() > longest) {
    const std::string mark = fmt::format("~{:016x}", std::hash<std::string>{}(name));
    name = name.substr(0, longest - ending.size() - mark.size()) + mark;
  }
  return folder_of(target) / (name + ending);
}

/// Held by a writer as long as it lives. Not flock(), which HDF5 may use on the same file.
bool locked_by_us(const Descriptor& file) {
  struct flock whole {};
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
  return ::fcntl(file, F_OFD_SETLK, &whole) == 0;
}

bool still_named(const Descriptor& file, const fs::path& name) {
  struct stat opened = {}, found = {};
  return ::fstat(file, &opened) == 0 && ::lstat(name.c_str(), &found) == 0 &&
         opened.st_ino == found.st_ino && opened.st_dev == found.st_dev;
}

/// Removes what a writer that died has left. false: it lives.
bool freed(const fs::path& name) {
  const Descriptor left(::open(name.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
  struct stat found = {};
  if (left < 0) return ::lstat(name.c_str(), &found) != 0;
  if (!locked_by_us(left)) return false;
  return !still_named(left, name) || ::unlink(name.c_str()) == 0;
}

[[noreturn]] void refuse(const fs::path& path) {
  throw InputError(fmt::format("{} cannot be written in the folder {}: {}", path.string(),
                               folder_of(path).string(), std::strerror(errno)));
}

std::string as_opened(const Descriptor& file) {
  return fmt::format("/proc/self/fd/{}", static_cast<int>(file));
}

Descriptor nameless_in(const fs::path& folder) {
  Descriptor file(::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0666));
  const bool can_be_named = file >= 0 && ::access(as_opened(file).c_str(), F_OK) == 0;
  return can_be_named ? std::move(file) : Descriptor();
}

void take_over_owner_and_rights(const Descriptor& file, const fs::path& older) {
  struct stat was = {}, is = {};
  if (::stat(older.c_str(), &was) != 0 || ::fstat(file, &is) != 0) return;
  const bool other_owner = was.st_uid != is.st_uid || was.st_gid != is.st_gid;
  if (other_owner && ::fchown(file, was.st_uid, was.st_gid) != 0) return;  // only root can
  (void)::fchmod(file, was.st_mode & 0777);
}

}  // namespace

PartFile::PartFile(const fs::path& path, Name name) : named_(path) {
  require_replaceable(path);
  target_ = target_of(path);
  if (name != Name::needed) file_ = nameless_in(folder_of(target_));
  if (file_ < 0) name == Name::unique ? take_unique_name() : take_name();
}

PartFile::~PartFile() {
  if (!part_.empty()) ::unlink(part_.c_str());
}

void PartFile::take_name() {
  for (const bool own : {false, true}) {
    const fs::path name = part_name(target_, own);
    if (!freed(name)) continue;
    Descriptor file(::open(name.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (file < 0 && errno == EEXIST) continue;  // a second writer came in between
    if (file < 0) refuse(named_);
    (void)locked_by_us(file);
    file_ = std::move(file);
    part_ = name;
    return;
  }
  throw std::runtime_error(
      fmt::format("{}: {} is in the way", named_.string(), part_name(target_, true).string()));
}

void PartFile::take_unique_name() {
  std::string name = target_.string() + ".XXXXXX.vortree.part";
  constexpr int ending = std::string_view(".vortree.part").size();
  file_ = Descriptor(::mkostemps(name.data(), ending, O_CLOEXEC));
  if (file_ < 0) refuse(named_);
  part_ = name;
  (void)::fchmod(file_, 0644);
}

bool PartFile::link_to(const fs::path& name) const {
  return ::linkat(AT_FDCWD, as_opened(file_).c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) ==
         0;
}

/// A file without a name can be given one that is free, but only a rename replaces another.
void PartFile::link_to_name() {
  (void)locked_by_us(file_);
  for (const bool own : {false, true}) {
    const fs::path name = part_name(target_, own);
    if (freed(name) && link_to(name)) {
      part_ = name;
      return;
    }
  }
  refuse(named_);
}

void PartFile::put_in_place(Until until) {
  take_over_owner_and_rights(file_, target_);
  if (until == Until::on_disk) force(file_, named_);
  const bool free = part_.empty() && link_to(target_);
  if (!free) {
    if (part_.empty()) link_to_name();
    if (::rename(part_.c_str(), target_.c_str()) != 0) {
      throw std::runtime_error(
          fmt::format("{} cannot be written: {}", named_.string(), std::strerror(errno)));
    }
    part_.clear();
  }
  if (until == Until::on_disk) force_folder(folder_of(target_));
}

bool PartFile::put_if_free() {
  force(file_, named_);
  const bool linked =
      part_.empty() ? link_to(target_) : ::link(part_.c_str(), target_.c_str()) == 0;
  if (!linked && errno == EEXIST) return false;
  if (!linked)
    throw std::runtime_error(
        fmt::format("{} cannot be written: {}", named_.string(), std::strerror(errno)));
  force_folder(folder_of(target_));
  return true;
}

}  // namespace vortree::io
