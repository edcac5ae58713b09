#include "io/frames/recovered.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <optional>
#include <string_view>

#include "io/files.hpp"
#include "io/part_file.hpp"

namespace vortree::io {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view signature = "\x89HDF\r\n\x1a\n";
// Superblock, version 0: after the signature a byte of version, ..., at byte 40 the end of file.
constexpr std::size_t end_of_file_at = 40;

/// The length that the superblock promises; nothing if the file ends before it says so.
std::optional<std::uint64_t> promised_bytes(const fs::path& path) {
  std::array<char, end_of_file_at + sizeof(std::uint64_t)> head{};
  std::ifstream in(path, std::ios::binary);
  in.read(head.data(), head.size());
  if (!in.is_open() || in.bad()) throw std::runtime_error(path.string() + " cannot be read");
  const std::string_view found(head.data(), static_cast<std::size_t>(in.gcount()));
  const std::size_t known = std::min(found.size(), signature.size());
  if (found.substr(0, known) != signature.substr(0, known)) {
    throw InputError(path.string() + " is not an HDF5 file");
  }
  if (found.size() < head.size()) return std::nullopt;
  if (head[signature.size()] != 0) return fs::file_size(path);
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, head.data() + end_of_file_at, sizeof bytes);
  return bytes;
}

/// Puts a copy beside the file, or where the system keeps such things.
/// throws  std::runtime_error if there is no room for it
void copy(const fs::path& path, std::optional<PartFile>& copied) {
  std::error_code error;
  for (const fs::path& place : {path, fs::temp_directory_path(error) / path.filename()}) {
    try {
      copied.emplace(place, PartFile::Name::needed);
    } catch (const std::runtime_error&) {
      continue;  // no right to write there
    }
    if (fs::copy_file(path, copied->path(), fs::copy_options::overwrite_existing, error)) return;
  }
  throw std::runtime_error(fmt::format("{} is cut short, and there is no room for a copy: {}",
                                       path.string(), error.message()));
}

}  // namespace

MendedFile open_mended(const fs::path& path) {
  require_regular_file(path);
  const auto promised = promised_bytes(path);
  const std::uint64_t bytes = fs::file_size(path);
  MendedFile opened;
  fs::path readable = path;
  std::optional<PartFile> copied;
  if (!promised) {
    opened.wound = fmt::format("is cut short at byte {}", bytes);
    return opened;
  }
  if (bytes < *promised) {
    opened.wound = fmt::format("is cut short at byte {} of {}", bytes, *promised);
    copy(path, copied);
    readable = copied->path();
    std::error_code error;
    fs::resize_file(readable, *promised, error);
    if (error) {
      opened.wound = fmt::format("is damaged at its beginning: it claims {} bytes", *promised);
      return opened;
    }
  }
  try {
    opened.file = h5::open_file(readable);
    (void)h5::links(opened.file);
  } catch (const h5::NotTheFile& refused) {
    throw std::runtime_error(fmt::format("{}: {}", path.string(), refused.what()));
  } catch (const h5::Failure&) {
    opened.file.close();
    if (opened.wound.empty()) opened.wound = "is damaged at its beginning";
  }
  return opened;
}

}  // namespace vortree::io
