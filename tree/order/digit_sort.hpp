#pragma once

#include <cstddef>
#include <cstdint>

#include "tree/base/memory.hpp"

namespace vortree::tree {

/// Some of the bits of a number, read as a number.
struct Digit {
  int low, bits;
  [[nodiscard]] std::size_t count() const { return std::size_t{1} << bits; }
  [[nodiscard]] std::size_t operator()(std::uint64_t number) const {
    return number >> low & (count() - 1);
  }
};

/// Sorts numbers ascending by their bits low..high - 1; stable.
///
/// Digit by digit, the lowest first: for numbers in which a few dozen bits differ, however these
/// are spread. (radix_sort begins with the highest, and stops where nothing is left to tell.)
///
/// cost      O(n) for every 14 bits, of fewer numbers for log2(n) - 2; 8 bytes a number to spare
/// threads   OpenMP; the result is the same for any number
void digit_sort(Unwritten<std::uint64_t>& numbers, int low, int high);

}  // namespace vortree::tree
