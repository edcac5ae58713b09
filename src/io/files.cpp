#include "io/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "io/input_error.hpp"

namespace vortree::io {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t longest_text = std::size_t{1} << 30;

/// Beside the file, so that a rename can put it in its place; no other process has that name.
fs::path fresh_name(const fs::path& path) {
  return path.string() + fmt::format(".{}.part", ::getpid());
}

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

}  // namespace

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
    throw InputError(
        fmt::format("{} has more than {} bytes; so long a text is not read", path.string(),
                    longest_text));
  }
  if (!in.eof()) throw InputError(fmt::format("{} cannot be read", path.string()));
  return text;
}

void require_writable(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) {
    throw InputError(fmt::format("{} is a folder; a file was expected", path.string()));
  }
  // Rights, quotas and file systems that cannot be written: only an attempt knows them all.
  const fs::path trial = fresh_name(path);
  const int descriptor = ::open(trial.c_str(), O_WRONLY | O_CREAT, 0666);
  if (descriptor < 0) {
    throw InputError(fmt::format("{} cannot be written in the folder {}: {}", path.string(),
                                 folder_of(path).string(), std::strerror(errno)));
  }
  ::close(descriptor);
  fs::remove(trial, error);
}

void replace_file(const fs::path& path, const std::function<void(const fs::path&)>& write) {
  const fs::path fresh = fresh_name(path);
  try {
    write(fresh);
    fs::rename(fresh, path);
  } catch (...) {
    std::error_code ignored;
    fs::remove(fresh, ignored);
    throw;
  }
}

void write_text(const fs::path& path, std::string_view text) {
  replace_file(path, [&](const fs::path& fresh) {
    std::ofstream out(fresh, std::ios::binary);
    out << text << std::flush;
    if (!out) {
      throw std::runtime_error(
          fmt::format("{} cannot be written: {}", path.string(), std::strerror(errno)));
    }
  });
}

}  // namespace vortree::io
