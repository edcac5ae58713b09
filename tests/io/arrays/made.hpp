#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

// Files of numpy's, made byte by byte.

namespace vortree::test {

/// A number's bytes, the lowest first; or the highest.
template <class Number>
std::string bytes_in(Number value, bool big_endian = false) {
  const auto* first = reinterpret_cast<const char*>(&value);
  std::string bytes(first, sizeof value);
  if (big_endian) std::ranges::reverse(bytes);
  return bytes;
}

template <class Number>
std::string bytes_in(const std::vector<Number>& values, bool big_endian = false) {
  std::string bytes;
  for (const Number value : values) bytes += bytes_in(value, big_endian);
  return bytes;
}

/// descr   as Python writes it, with its quotes or brackets
inline std::string npy_with(const std::string& dictionary, const std::string& data,
                            int version = 1) {
  std::string bytes = "\x93NUMPY" + std::string(1, static_cast<char>(version)) + '\0';
  const std::string header = dictionary + "\n";
  bytes += version == 1 ? bytes_in(static_cast<std::uint16_t>(header.size()))
                        : bytes_in(static_cast<std::uint32_t>(header.size()));
  return bytes + header + data;
}

inline std::string npy(const std::string& descr, const std::string& shape, const std::string& data,
                       bool fortran_order = false) {
  return npy_with("{'descr': " + descr + ", 'fortran_order': " +
                      (fortran_order ? "True" : "False") + ", 'shape': " + shape + ", }",
                  data);
}

/// One dimension of float64.
inline std::string npy(const std::vector<double>& values) {
  return npy("'<f8'", "(" + std::to_string(values.size()) + ",)", bytes_in(values));
}

/// Bit by bit, as it is defined.
inline std::uint32_t plain_crc32(std::string_view bytes) {
  std::uint32_t sum = ~0u;
  for (const unsigned char byte : bytes) {
    sum ^= byte;
    for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1) ^ (sum & 1 ? 0xedb88320u : 0u);
  }
  return ~sum;
}

/// method   0 stored, 8 deflated
/// packed   what stands in the file; the bytes themselves, if empty
struct MadeMember {
  std::string name, bytes;
  std::uint16_t method = 0;
  std::string packed{};
  std::uint16_t flags = 0;
  bool long_numbers = false;  // in the extra field of zip64

  const std::string& there() const { return packed.empty() ? bytes : packed; }
};

inline std::string traits_of(const MadeMember& one) {
  return bytes_in<std::uint16_t>(20) + bytes_in(one.flags) + bytes_in(one.method) +
         bytes_in<std::uint32_t>(0) + bytes_in(plain_crc32(one.bytes));
}

inline std::string lengths_of(const MadeMember& one) {
  if (one.long_numbers) return bytes_in(~0u) + bytes_in(~0u);
  return bytes_in(static_cast<std::uint32_t>(one.there().size())) +
         bytes_in(static_cast<std::uint32_t>(one.bytes.size()));
}

inline std::string extra_of(const MadeMember& one, std::uint64_t header) {
  if (!one.long_numbers) return {};
  return bytes_in<std::uint16_t>(0x5455) + bytes_in<std::uint16_t>(1) + "t" +  // another's
         bytes_in<std::uint16_t>(1) + bytes_in<std::uint16_t>(24) +
         bytes_in<std::uint64_t>(one.bytes.size()) + bytes_in<std::uint64_t>(one.there().size()) +
         bytes_in(header);
}

inline std::string zip(const std::vector<MadeMember>& members, const std::string& comment = "",
                       bool long_directory = false) {
  std::string file, directory;
  for (const MadeMember& one : members) {
    const std::string extra = extra_of(one, file.size());
    const auto names = bytes_in(static_cast<std::uint16_t>(one.name.size()));
    directory += "PK\1\2" + bytes_in<std::uint16_t>(20) + traits_of(one) + lengths_of(one) + names +
                 bytes_in(static_cast<std::uint16_t>(extra.size())) + std::string(10, '\0') +
                 bytes_in(one.long_numbers ? ~0u : static_cast<std::uint32_t>(file.size())) +
                 one.name + extra;
    file += "PK\3\4" + traits_of(one) + lengths_of(one) + names + bytes_in<std::uint16_t>(5) +
            one.name + "extra" + one.there();
  }
  const std::uint64_t begin = file.size(), end = begin + directory.size();
  file += directory;
  if (long_directory)
    file += "PK\6\6" + bytes_in<std::uint64_t>(44) + std::string(20, '\0') +
            bytes_in<std::uint64_t>(members.size()) + bytes_in<std::uint64_t>(directory.size()) +
            bytes_in(begin) + "PK\6\7" + std::string(4, '\0') + bytes_in(end) +
            bytes_in<std::uint32_t>(1);
  const auto count = static_cast<std::uint16_t>(long_directory ? 0xffff : members.size());
  return file + "PK\5\6" + std::string(4, '\0') + bytes_in<std::uint16_t>(count) + bytes_in(count) +
         bytes_in(static_cast<std::uint32_t>(directory.size())) +
         bytes_in(long_directory ? ~0u : static_cast<std::uint32_t>(begin)) +
         bytes_in(static_cast<std::uint16_t>(comment.size())) + comment;
}

/// Deflated without any packing: blocks of bytes as they are.
inline std::string in_plain_blocks(const std::string& bytes) {
  constexpr std::size_t longest = 1000;
  std::string packed;
  for (std::size_t at = 0; at < bytes.size(); at += longest) {
    const auto length = static_cast<std::uint16_t>(std::min(longest, bytes.size() - at));
    packed += at + longest >= bytes.size() ? '\1' : '\0';
    packed +=
        bytes_in(length) + bytes_in(static_cast<std::uint16_t>(~length)) + bytes.substr(at, length);
  }
  return packed;
}

}  // namespace vortree::test
