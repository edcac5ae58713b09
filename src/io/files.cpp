#include "io/files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "io/input_error.hpp"

namespace vortree::io {
namespace fs = std::filesystem;

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
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const fs::file_status status = fs::status(folder, error);
  if (status.type() == fs::file_type::directory) {
    if (::access(folder.c_str(), W_OK) == 0) return;
    throw InputError(fmt::format("{} cannot be written: no right to write in the folder {} ({})",
                                 path.string(), folder.string(), std::strerror(errno)));
  }
  throw InputError(fmt::format("{} cannot be written: {} is {}", path.string(), folder.string(),
                               fs::exists(status) ? "not a folder" : "no folder that exists"));
}

void replace_file(const fs::path& path, const std::function<void(const fs::path&)>& write) {
  const fs::path fresh = path.string() + fmt::format(".{}.part", ::getpid());
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
