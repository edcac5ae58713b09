#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/arrays/array_file.hpp"

namespace vortree::io {

/// A file within a zip file, as the directory at its end tells of it.
struct ZipMember {
  std::string name{};
  std::uint64_t flags = 0, method = 0, crc = 0, packed = 0, size = 0, header = 0;
};

/// throws  BadArray: no zip file, cut short, a directory that is damaged or spread over several
///         disks
/// source  PKWARE, APPNOTE.TXT 6.3.10: 4.3.7 to 4.3.16, 4.5.3
[[nodiscard]] std::vector<ZipMember> zip_members(std::string_view zip);

/// The bytes of a member, in `zip` itself if they are stored, in `room` if they had to be unpacked.
///
/// throws  BadArray: encrypted, packed by anything but deflate, damaged (its CRC is another),
///         longer than the file; as inflated()
[[nodiscard]] std::string_view bytes_of(const ZipMember& member, std::string_view zip,
                                        std::string& room);

/// The sum that zip files keep: CRC-32 of the polynomial 0xedb88320.
[[nodiscard]] std::uint32_t crc32_of(std::string_view bytes);

/// A file to be put into a zip file.
struct ZipEntry {
  std::string name, bytes;
};

/// Members stored as they are, all of the date 1980-01-01, so that equal contents are equal files.
/// throws  BadArray if it would have 4 GiB or more
[[nodiscard]] std::string zip_of(std::span<const ZipEntry> entries);

}  // namespace vortree::io
