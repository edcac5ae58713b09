#include "io/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "io/input_error.hpp"
#include "io/part_file.hpp"

namespace vortree::io {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t longest_text = std::size_t{1} << 30;

[[noreturn]] void refuse(const fs::path& path, std::string_view words) {
  throw InputError(fmt::format("{} {}", path.string(), words));
}

std::string_view kind_of(const struct stat& found) {
  if (S_ISDIR(found.st_mode)) return "a folder";
  if (S_ISFIFO(found.st_mode)) return "a pipe";
  if (S_ISSOCK(found.st_mode)) return "a socket";
  return "a device";
}

void write_text(const fs::path& path, std::string_view text, PartFile::Until until) {
  PartFile part(path, PartFile::Name::none);
  write_whole(part.descriptor(), text, path);
  part.put_in_place(until);
}

}  // namespace

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

fs::path target_of(const fs::path& path) {
  constexpr int most_links = 40;  // as the system
  fs::path at = path;
  for (int k = 0; k < most_links; ++k) {
    std::error_code no_link;
    const fs::path to = fs::read_symlink(at, no_link);
    if (no_link) return at;
    at = folder_of(at) / to;  // an absolute `to` replaces all
  }
  refuse(path, "is a link that leads to itself");
}

bool keeps_suffix(const fs::path& path) {
  return target_of(path).extension() == path.extension();
}

void require_file(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) {
    throw InputError(fmt::format("{}: no such file", path.string()));
  }
  if (status.type() == fs::file_type::directory) {
    throw InputError(fmt::format("{} is a folder; a file was expected", path.string()));
  }
  if (::access(path.c_str(), R_OK) != 0) {
    throw InputError(fmt::format("{} cannot be read: {}", path.string(), std::strerror(errno)));
  }
}

void require_regular_file(const fs::path& path) {
  require_file(path);
  std::error_code error;
  if (!fs::is_regular_file(path, error)) {
    throw InputError(fmt::format("{} is a device or a pipe; a file was expected", path.string()));
  }
}

std::string read_text(const fs::path& path) {
  require_file(path);
  std::ifstream in(path, std::ios::binary);
  std::string text;
  // A device may give bytes without end.
  for (std::string piece(1 << 16, '\0'); in && text.size() <= longest_text;) {
    in.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    text.append(piece, 0, static_cast<std::size_t>(in.gcount()));
  }
  if (text.size() > longest_text) {
    throw InputError(fmt::format("{} has more than {} bytes; so long a text is not read",
                                 path.string(), longest_text));
  }
  if (!in.eof()) throw InputError(fmt::format("{} cannot be read", path.string()));
  return text;
}

void require_replaceable(const fs::path& path, std::span<const fs::path> inputs) {
  if (path.empty()) throw InputError("an output needs a name; an empty one was given");
  struct stat found = {}, input = {};
  if (::stat(path.c_str(), &found) != 0) return;
  if (!S_ISREG(found.st_mode)) {
    refuse(path, fmt::format("is {}; a file was expected", kind_of(found)));
  }
  for (const fs::path& read : inputs) {
    const bool there = ::stat(read.c_str(), &input) == 0;
    if (there && input.st_ino == found.st_ino && input.st_dev == found.st_dev) {
      refuse(path, fmt::format("is the input {}; the output would destroy it", read.string()));
    }
  }
  if (::access(path.c_str(), W_OK) != 0) {
    refuse(path, fmt::format("cannot be written: {}", std::strerror(errno)));
  }
}

void require_writable(const fs::path& path, std::span<const fs::path> inputs) {
  require_replaceable(path, inputs);
  // Rights, quotas and file systems that cannot be written: only an attempt knows them all.
  const PartFile attempt(path, PartFile::Name::none);
}

void replace_file(const fs::path& path, const std::function<void(const fs::path&)>& write) {
  PartFile part(path, PartFile::Name::needed);
  write(part.path());
  part.put_in_place();
}

void write_text(const fs::path& path, std::string_view text) {
  write_text(path, text, PartFile::Until::on_disk);
}

bool write_new_text(const fs::path& path, std::string_view text) {
  PartFile part(path, PartFile::Name::unique);
  write_whole(part.descriptor(), text, path);
  return part.put_if_free();
}

void write_derived_text(const fs::path& path, std::string_view text) {
  write_text(path, text, PartFile::Until::with_system);
}

void remove_file(const fs::path& path) {
  require_replaceable(path);
  const fs::path target = target_of(path);
  if (::unlink(target.c_str()) == 0) return force_folder(folder_of(target));
  if (errno != ENOENT) refuse(path, fmt::format("cannot be removed: {}", std::strerror(errno)));
}

Descriptor open_to_append(const fs::path& path) {
  require_replaceable(path);
  Descriptor file(::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC));
  if (file < 0) refuse(path, fmt::format("cannot be written: {}", std::strerror(errno)));
  return file;
}

}  // namespace vortree::io
