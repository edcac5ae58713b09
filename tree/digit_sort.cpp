#include "tree/digit_sort.hpp"

#include <span>
#include <utility>
#include <vector>

#include "tree/pieces.hpp"

namespace vortree::tree {

namespace {

// More places to write to than lines of the nearest caches make writing slow.
constexpr int most_digit_bits = 11;

struct Digit {
  int low, bits;
  [[nodiscard]] std::size_t count() const { return std::size_t{1} << bits; }
  [[nodiscard]] std::size_t operator()(std::uint64_t number) const {
    return number >> low & (count() - 1);
  }
};

// Each piece counts for itself, so that threads share the work and the order is kept.
void part(std::span<const std::uint64_t> from, Digit digit, std::span<std::uint64_t> to) {
  const std::size_t pieces = pieces_of(from.size());
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
  for (int digits = (high - low + most_digit_bits - 1) / most_digit_bits; digits > 0; --digits) {
    const int bits = (high - low + digits - 1) / digits;
    part(numbers, {low, bits}, spare);
    std::swap(numbers, spare);
    low += bits;
  }
}

}  // namespace vortree::tree
