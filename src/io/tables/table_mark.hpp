#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "io/input_error.hpp"

namespace vortree::io {

/// What a checkpoint keeps of a table, to know it again: how far it went, and a checksum of all
/// that stood before.
struct TableMark {
  std::uint64_t rows = 0, bytes = 0, checksum = 0;

  /// With one more line, which the first time names the columns; the line end comes on top.
  void add(std::string_view line);

  bool operator==(const TableMark&) const = default;
};

/// As doubles (a 64-bit checksum in two halves), and back; nothing if they are no mark.
[[nodiscard]] std::vector<double> as_numbers(const TableMark&);
[[nodiscard]] std::optional<TableMark> mark_of(std::span<const double> numbers);

/// Is the beginning of the text what the mark was made of?
[[nodiscard]] bool begins_with(std::string_view text, const TableMark&);

}  // namespace vortree::io
