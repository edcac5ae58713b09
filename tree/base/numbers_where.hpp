#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tree/base/memory.hpp"
#include "tree/base/parallel.hpp"

namespace vortree::tree {

/// Where what comes from each piece of n things begins in a row, and the end, when thing i leaves
/// count(i).
std::array<std::size_t, shared_pieces + 1> begins_of_pieces(std::size_t n, std::size_t pieces,
                                                            const auto& count) {
  std::array<std::size_t, shared_pieces + 1> begins{};
  for_each_piece(pieces, [&](std::size_t p) {
    const Range own = piece(n, p, pieces);
    std::size_t sum = 0;
    for (std::uint32_t i = own.first; i < own.last; ++i) sum += count(i);
    begins[p + 1] = sum;
  });
  for (std::size_t p = 0; p < pieces; ++p) begins[p + 1] += begins[p];
  return begins;
}

/// The numbers i < n for which holds(i), ascending; looked for by all threads where there are many.
/// Each is asked twice.
std::vector<std::uint32_t> numbers_where(std::size_t n, const auto& holds) {
  const std::size_t pieces = n > records_worth_sharing ? shared_pieces : 1;
  const auto begins = begins_of_pieces(n, pieces, holds);
  std::vector<std::uint32_t> numbers(begins[pieces]);
  for_each_piece(pieces, [&](std::size_t p) {
    const Range own = piece(n, p, pieces);
    std::size_t next = begins[p];
    for (std::uint32_t i = own.first; i < own.last; ++i)
      if (holds(i)) numbers[next++] = i;
  });
  return numbers;
}

/// Of each of these numbers what make(i) says, made by all threads.
template <class Made>
Unwritten<Made> made_of(std::span<const std::uint32_t> numbers, const auto& make) {
  Unwritten<Made> made(numbers.size());
  const auto n = static_cast<std::ptrdiff_t>(numbers.size());
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t k = 0; k < n; ++k) made[k] = make(numbers[k]);
  return made;
}

}  // namespace vortree::tree
