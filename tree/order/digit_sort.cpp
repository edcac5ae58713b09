#include "tree/order/digit_sort.hpp"

#include <omp.h>

#include <algorithm>
#include <bit>
#include <span>
#include <utility>
#include <vector>

#include "tree/base/parallel.hpp"
#include "tree/base/tuning.hpp"

namespace vortree::tree {

namespace {

int most_bits(std::size_t n) {
  return std::clamp(static_cast<int>(std::bit_width(n)) - 2, least_digit_bits, most_digit_bits);
}

// Each piece counts for itself, so that threads share the work and the order is kept.
void part(std::span<const std::uint64_t> from, Digit digit, std::span<std::uint64_t> to) {
  const std::size_t threads = static_cast<std::size_t>(omp_get_max_threads());
  const std::size_t pieces = std::min(pieces_of(from.size()), threads);
  std::vector<std::uint32_t> places(pieces * digit.count(), 0);
  for_each_piece(pieces, [&](std::size_t p) {
    const Range own = piece(from.size(), p, pieces);
    std::uint32_t* counts = &places[p * digit.count()];
    for (const std::uint64_t number : from.subspan(own.first, own.size())) ++counts[digit(number)];
  });
  std::uint32_t next = 0;
  for (std::size_t d = 0; d < digit.count(); ++d) {
    for (std::size_t p = 0; p < pieces; ++p) {
      next += std::exchange(places[p * digit.count() + d], next);
    }
  }
  for_each_piece(pieces, [&](std::size_t p) {
    const Range own = piece(from.size(), p, pieces);
    std::uint32_t* place = &places[p * digit.count()];
    for (const std::uint64_t number : from.subspan(own.first, own.size())) {
      to[place[digit(number)]++] = number;
    }
  });
}

}  // namespace

void digit_sort(Unwritten<std::uint64_t>& numbers, int low, int high) {
  Unwritten<std::uint64_t> spare(numbers.size());
  const int most = most_bits(numbers.size());
  for (int digits = (high - low + most - 1) / most; digits > 0; --digits) {
    const int bits = (high - low + digits - 1) / digits;
    part(numbers, {low, bits}, spare);
    std::swap(numbers, spare);
    low += bits;
  }
}

}  // namespace vortree::tree
