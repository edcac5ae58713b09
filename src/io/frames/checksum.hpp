#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <string_view>

namespace vortree::io {

/// A 64-bit sum that notices a changed, missing, added or moved value.
///
/// Each word goes through h -> mix((h xor word) * odd), which is invertible: any single wrong word
/// is noticed for certain, anything else but for one case in 2^64. In the manner of FNV-1a, eight
/// bytes at a time. It guards against accidents, not against intent.
class Checksum {
 public:
  void add(std::uint64_t word) {
    sum_ = (sum_ ^ word) * 0x100000001b3ULL;
    sum_ ^= sum_ >> 29;
  }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(std::span<const double> values) {
    add(std::uint64_t{values.size()});
    for (const double value : values) add(value);
  }
  void add(std::string_view text) {
    add(std::uint64_t{text.size()});
    for (const unsigned char c : text) add(std::uint64_t{c});
  }

  [[nodiscard]] std::uint64_t value() const { return sum_; }

 private:
  std::uint64_t sum_ = 0xcbf29ce484222325ULL;
};

}  // namespace vortree::io
