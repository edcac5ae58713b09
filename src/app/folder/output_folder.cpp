#include "app/folder/output_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>

#include "app/say.hpp"
#include "io/input_error.hpp"

namespace vortree::app {
namespace {

namespace fs = std::filesystem;

/// ", process 1234" as the system lists its locks, or nothing if it does not tell.
std::string holder_of(const io::Descriptor& folder) {
  struct stat held = {};
  if (::fstat(folder, &held) != 0) return {};
  const std::string inode =
      fmt::format("{:02x}:{:02x}:{}", major(held.st_dev), minor(held.st_dev), held.st_ino);
  std::ifstream locks("/proc/locks");
  for (std::string line; std::getline(locks, line);) {
    std::istringstream words(line);
    std::string number, kind, strength, access, process, place;
    words >> number >> kind >> strength >> access >> process >> place;
    if (kind == "FLOCK" && place == inode && process != "0") return ", process " + process;
  }
  return {};
}

[[noreturn]] void refuse(const fs::path& folder, const std::string& why) {
  throw io::InputError(fmt::format("{}: {}", folder.string(), why));
}

/// A link without an end, on the way to the folder or the folder itself.
void refuse_broken_link(const fs::path& folder) {
  std::error_code unseen;
  for (fs::path at = folder; at.has_relative_path(); at = at.parent_path())
    if (fs::is_symlink(at, unseen) && !fs::exists(at, unseen))
      refuse(at, fmt::format("is a link to {}, where nothing is; a folder was expected",
                             fs::read_symlink(at, unseen).string()));
}

/// true if it was not there before
bool made(const fs::path& folder) {
  if (folder.empty()) throw io::InputError("the folder for the results needs a name");
  std::error_code error, unseen;
  const bool created = fs::create_directories(folder, error);
  if (fs::is_directory(folder, unseen)) return created;
  refuse_broken_link(folder);
  if (!error || fs::exists(folder, unseen)) refuse(folder, "is a file; a folder was expected");
  refuse(folder, "cannot be made: " + error.message());
}

}  // namespace

OutputFolder::OutputFolder(const fs::path& path, Use use)
    : path_(path),
      made_(made(path)),
      folder_(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (folder_ >= 0 && ::flock(folder_, (use == Use::alone ? LOCK_EX : LOCK_SH) | LOCK_NB) == 0) {
    if (made_) io::force_folder(fs::absolute(path).lexically_normal().parent_path());
    return;
  }
  if (folder_ >= 0 && errno == EWOULDBLOCK) {
    refuse(path, fmt::format("another vortree writes there{}; wait for its end, or choose another "
                             "folder with --out",
                             holder_of(folder_)));
  }
  say("{}: cannot be locked ({}); see to it that nothing else writes there", path.string(),
      std::strerror(errno));
}

OutputFolder::~OutputFolder() {
  if (made_) ::rmdir(path_.c_str());  // refused by the system if there is something in it
}

bool being_filled(const fs::path& path) {
  const io::Descriptor folder(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  return folder >= 0 && !holder_of(folder).empty();
}

}  // namespace vortree::app
