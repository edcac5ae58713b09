#include "io/arrays/zip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "io/arrays/bytes.hpp"
#include "io/arrays/inflate.hpp"

namespace vortree::io {
namespace {

// What records of a zip file begin with, and how long they are without names.
constexpr std::uint64_t local_mark = 0x04034b50, local_length = 30;
constexpr std::uint64_t directory_mark = 0x02014b50, directory_length = 46;
constexpr std::uint64_t end_mark = 0x06054b50, end_length = 22;
constexpr std::uint64_t end64_mark = 0x06064b50, locator_mark = 0x07064b50, locator_length = 20;

constexpr std::uint64_t in_zip64_16 = 0xffff, in_zip64_32 = 0xffffffff;
constexpr std::uint64_t stored = 0, deflated = 8;

/// How many members, and where the list of them begins.
struct ZipDirectory {
  std::uint64_t members, begin;
};

/// A comment of up to 64 KiB may stand behind the record at the end.
std::uint64_t end_of_directory(std::string_view zip) {
  if (zip.size() >= end_length) {
    const std::uint64_t last = zip.size() - end_length;
    for (std::uint64_t back = 0; back <= std::min<std::uint64_t>(last, 0xffff); ++back)
      if (little_endian(zip, last - back, 4) == end_mark &&
          little_endian(zip, last - back + 20, 2) == back)
        return last - back;
  }
  if (zip.starts_with("PK")) throw BadArray("it is a zip file, but cut short: its end is missing");
  throw BadArray("it is not a zip file, as .npz files are");
}

ZipDirectory directory_of(std::string_view zip) {
  const std::uint64_t end = end_of_directory(zip);
  ZipDirectory found{little_endian(zip, end + 10, 2), little_endian(zip, end + 16, 4)};
  if (little_endian(zip, end + 4, 2) % in_zip64_16 != 0)
    throw BadArray("it is a part of a zip file of several parts");
  if (found.members != in_zip64_16 && found.begin != in_zip64_32) return found;
  if (end < locator_length || little_endian(zip, end - locator_length, 4) != locator_mark)
    return found;
  const std::uint64_t at = little_endian(zip, end - locator_length + 8, 8);
  if (little_endian(zip, at, 4) != end64_mark)
    throw BadArray("it is a zip file, but damaged: its long directory is missing");
  return {little_endian(zip, at + 32, 8), little_endian(zip, at + 48, 8)};
}

/// Those of the three numbers that are too long for 32 bits stand in an extra field, in this order.
void read_long_numbers(ZipMember& member, std::string_view extra) {
  for (std::uint64_t at = 0; at + 4 <= extra.size();) {
    const std::uint64_t kind = little_endian(extra, at, 2),
                        length = little_endian(extra, at + 2, 2);
    at += 4;
    if (kind == 1) {
      for (std::uint64_t* number : {&member.size, &member.packed, &member.header}) {
        if (*number != in_zip64_32) continue;
        *number = little_endian(extra, at, 8);
        at += 8;
      }
      return;
    }
    at += length;
  }
}

/// The member told at a place of the directory; `at` goes on to the next.
ZipMember member_at(std::string_view zip, std::uint64_t& at) {
  if (little_endian(zip, at, 4) != directory_mark)
    throw BadArray("it is a zip file, but damaged: its directory is not where its end says");
  ZipMember member{.flags = little_endian(zip, at + 8, 2),
                   .method = little_endian(zip, at + 10, 2),
                   .crc = little_endian(zip, at + 16, 4),
                   .packed = little_endian(zip, at + 20, 4),
                   .size = little_endian(zip, at + 24, 4),
                   .header = little_endian(zip, at + 42, 4)};
  const std::uint64_t name = little_endian(zip, at + 28, 2), extra = little_endian(zip, at + 30, 2),
                      comment = little_endian(zip, at + 32, 2);
  at += directory_length;
  member.name = piece(zip, at, name);
  read_long_numbers(member, piece(zip, at + name, extra));
  at += name + extra + comment;
  return member;
}

std::string_view packed_bytes(const ZipMember& member, std::string_view zip) {
  if (little_endian(zip, member.header, 4) != local_mark)
    throw BadArray("it is damaged: it does not begin where the directory says");
  const std::uint64_t names =
      little_endian(zip, member.header + 26, 2) + little_endian(zip, member.header + 28, 2);
  return piece(zip, member.header + local_length + names, member.packed);
}

std::string_view packer(std::uint64_t method) {
  switch (method) {
    case 9:
      return "deflate64";
    case 12:
      return "bzip2";
    case 14:
      return "LZMA";
    case 93:
      return "Zstandard";
    case 95:
      return "XZ";
    default:
      return "an unknown method";
  }
}

std::string_view unpacked(const ZipMember& member, std::string_view zip, std::string& room) {
  constexpr std::uint64_t encrypted = 1;
  if (member.flags & encrypted) throw BadArray("it is encrypted");
  if (member.method != stored && member.method != deflated)
    throw BadArray(
        fmt::format("it is packed by {} (zip method {}); numpy.savez and "
                    "numpy.savez_compressed were expected",
                    packer(member.method), member.method));
  const std::string_view packed = packed_bytes(member, zip);
  if (member.method == deflated) return room = inflated(packed, member.size);
  if (packed.size() == member.size) return packed;
  throw BadArray(
      fmt::format("it is damaged: it claims {} bytes and {}", packed.size(), member.size));
}

/// Eight bytes at a time: row k takes a byte on over k zeros behind it.
using CrcTables = std::array<std::array<std::uint32_t, 256>, 8>;

constexpr CrcTables crc_tables() {
  CrcTables tables{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t sum = byte;
    for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1) ^ ((sum & 1) != 0 ? 0xedb88320u : 0u);
    tables[0][byte] = sum;
  }
  for (std::size_t k = 1; k < 8; ++k)
    for (std::size_t byte = 0; byte < 256; ++byte) {
      const std::uint32_t before = tables[k - 1][byte];
      tables[k][byte] = (before >> 8) ^ tables[0][before & 0xff];
    }
  return tables;
}

/// Version that reads it, flags (names in UTF-8), method, time and date: a local header, and the
/// directory's record, go on with them.
void add_traits(std::string& text) {
  constexpr std::uint64_t version = 20, utf8 = 1 << 11, first_of_1980 = 0x21;
  for (const std::uint64_t trait : {version, utf8, stored, std::uint64_t{0}, first_of_1980})
    add_little_endian(text, trait, 2);
}

void add_lengths(std::string& text, const ZipEntry& entry) {
  add_little_endian(text, crc32_of(entry.bytes), 4);
  add_little_endian(text, entry.bytes.size(), 4);
  add_little_endian(text, entry.bytes.size(), 4);
  add_little_endian(text, entry.name.size(), 2);
}

void add_local(std::string& text, const ZipEntry& entry) {
  add_little_endian(text, local_mark, 4);
  add_traits(text);
  add_lengths(text, entry);
  add_little_endian(text, 0, 2);  // no extra
  text += entry.name;
  text += entry.bytes;
}

void add_to_directory(std::string& text, const ZipEntry& entry, std::uint64_t header) {
  add_little_endian(text, directory_mark, 4);
  add_little_endian(text, 20, 2);  // made by
  add_traits(text);
  add_lengths(text, entry);
  for (const unsigned width : {2, 2, 2, 2, 4}) add_little_endian(text, 0, width);
  add_little_endian(text, header, 4);
  text += entry.name;
}

void add_end(std::string& text, std::uint64_t members, std::uint64_t begin) {
  const std::uint64_t length = text.size() - begin;
  add_little_endian(text, end_mark, 4);
  add_little_endian(text, 0, 4);  // this disk, that of the directory
  add_little_endian(text, members, 2);
  add_little_endian(text, members, 2);
  add_little_endian(text, length, 4);
  add_little_endian(text, begin, 4);
  add_little_endian(text, 0, 2);  // no comment
}

void require_short(std::span<const ZipEntry> entries) {
  std::uint64_t length = end_length;
  for (const ZipEntry& entry : entries)
    length += local_length + directory_length + 2 * entry.name.size() + entry.bytes.size();
  if (length > in_zip64_32)
    throw BadArray(
        fmt::format("it would have {:.3g} GB, and an .npz is written up to 4.29 GB: "
                    "write an .h5",
                    1e-9 * static_cast<double>(length)));
}

}  // namespace

std::vector<ZipMember> zip_members(std::string_view zip) {
  const ZipDirectory directory = directory_of(zip);
  std::vector<ZipMember> members;
  std::uint64_t at = directory.begin;
  for (std::uint64_t k = 0; k < directory.members; ++k) members.push_back(member_at(zip, at));
  return members;
}

std::string_view bytes_of(const ZipMember& member, std::string_view zip, std::string& room) {
  const std::string_view bytes = unpacked(member, zip, room);
  const std::uint32_t crc = crc32_of(bytes);
  if (crc == member.crc) return bytes;
  throw BadArray(fmt::format("it is damaged: its CRC is {:08x}, not {:08x}", crc, member.crc));
}

std::uint32_t crc32_of(std::string_view bytes) {
  static constexpr CrcTables tables = crc_tables();
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  std::uint32_t sum = 0xffffffff;
  std::size_t i = 0;
  for (; i + 8 <= bytes.size(); i += 8) {
    std::uint32_t next = 0;
    for (unsigned k = 0; k < 8; ++k) {
      const std::uint32_t before = k < 4 ? sum >> (8 * k) & 0xff : 0;
      next ^= tables[7 - k][before ^ byte(i + k)];
    }
    sum = next;
  }
  for (; i < bytes.size(); ++i) sum = (sum >> 8) ^ tables[0][(sum & 0xff) ^ byte(i)];
  return ~sum;
}

std::string zip_of(std::span<const ZipEntry> entries) {
  require_short(entries);
  std::string text, directory;
  for (const ZipEntry& entry : entries) {
    add_to_directory(directory, entry, text.size());
    add_local(text, entry);
  }
  const std::uint64_t begin = text.size();
  text += directory;
  add_end(text, entries.size(), begin);
  return text;
}

}  // namespace vortree::io
