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

std::string read_text(const fs::path& path) {
  require_file(path);
  std::ifstream in(path, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(in), {});
  if (!in && !in.eof()) throw InputError(fmt::format("{} cannot be read", path.string()));
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
