#include "tree/order/run_sort.hpp"

#include <algorithm>
#include <bit>

#include "tree/base/tuning.hpp"

namespace vortree::tree {

namespace {

void insert(std::uint64_t number, std::uint64_t* begin, std::uint64_t* place) {
  for (; place > begin && place[-1] > number; --place) *place = place[-1];
  *place = number;
}

// Two numbers in order.
struct Ordered {
  std::uint64_t low, high;
  Ordered(std::uint64_t a, std::uint64_t b) : low(a < b ? a : b), high(a < b ? b : a) {}
};

// Sorts numbers that are nearly in order on their way to another place. Two of them are held back
// and the least of three goes on, without a branch: that alone puts groups of up to three right.
void insert_in_order(std::span<const std::uint64_t> from, std::span<std::uint64_t> to) {
  const Ordered first(from[0], from[1]);
  std::uint64_t middle = first.low, high = first.high;
  std::uint64_t* place = to.data();
  for (std::size_t i = 2; i < from.size(); ++i) {
    const Ordered upper(high, from[i]), lower(middle, upper.low);
    high = upper.high;
    middle = lower.high;
    insert(lower.low, to.data(), place++);
  }
  insert(middle, to.data(), place++);
  insert(high, to.data(), place);
}

}  // namespace

int RunSort::most_bits(std::size_t n) {
  return 64 - static_cast<int>(std::bit_width(n - 1));
}

void RunSort::operator()(std::span<const Record> run, MortonKey differing,
                         std::span<MortonKey> keys, std::span<std::uint32_t> index) {
  const std::size_t n = run.size();
  if (numbers_.size() < n) numbers_.resize(n), spare_.resize(n);
  const std::span<std::uint64_t> numbers(numbers_.data(), n);
  if (differing == 0) {
    for (std::size_t i = 0; i < n; ++i) keys[i] = run[i].key, index[i] = run[i].index;
    return;
  }
  const int shared = std::countl_zero(differing);
  const std::uint64_t places = std::bit_ceil(n) - 1;
  for (std::size_t i = 0; i < n; ++i) numbers[i] = (run[i].key << shared & ~places) | i;
  sort(numbers, {spare_.data(), n});
  for (std::size_t i = 0; i < n; ++i) {
    const Record& record = run[numbers[i] & places];
    keys[i] = record.key;
    index[i] = record.index;
  }
}

// What shares all bits that count is rare in a short run: insertion puts it right.
void RunSort::whole(std::span<MortonKey> keys, std::span<std::uint32_t> index) {
  const std::size_t n = keys.size();
  records_.resize(n);
  MortonKey differing = 0;
  for (std::size_t i = 0; i < n; ++i) {
    records_[i] = {keys[i], index[i]};
    differing |= keys[i] ^ keys[0];
  }
  (*this)(records_, differing, keys, index);
  for (std::size_t i = 1; i < n; ++i) {
    const Record record{keys[i], index[i]};
    std::size_t place = i;
    for (; place > 0 && keys[place - 1] > record.key; --place) {
      keys[place] = keys[place - 1], index[place] = index[place - 1];
    }
    keys[place] = record.key, index[place] = record.index;
  }
}

// The leading bits differ, or the run is short.
void RunSort::sort(std::span<std::uint64_t> numbers, std::span<std::uint64_t> spare) {
  if (numbers.size() <= insertion_run) {
    for (std::uint64_t& number : numbers) insert(number, numbers.data(), &number);
    return;
  }
  std::uint64_t differing = 0;
  for (const std::uint64_t number : numbers) differing |= number ^ numbers[0];
  const int shared = std::countl_zero(differing);
  const int bits = std::min<int>(run_digit_bits, std::bit_width(numbers.size()));
  const auto digit = [=](std::uint64_t number) { return number << shared >> (64 - bits); };

  const std::size_t digits = std::size_t{1} << bits;
  place_.assign(digits, 0);
  for (const std::uint64_t number : numbers) ++place_[digit(number)];
  std::uint32_t next = 0, most = 0;
  for (std::uint32_t& place : place_) {
    const std::uint32_t count = place;
    most = std::max(most, count);
    place = next;
    next += count;
  }
  for (const std::uint64_t number : numbers) spare[place_[digit(number)]++] = number;
  if (most <= insertion_run) return insert_in_order(spare, numbers);
  // Crowds are sorted one by one; the table of places is used again for each.
  for (std::size_t first = 0, last = 0; first < spare.size(); first = last) {
    const std::uint64_t shared_digit = digit(spare[first]);
    for (last = first + 1; last < spare.size() && digit(spare[last]) == shared_digit;) ++last;
    const std::size_t n = last - first;
    std::copy_n(spare.begin() + first, n, numbers.begin() + first);
    sort(numbers.subspan(first, n), spare.subspan(first, n));
  }
}

}  // namespace vortree::tree
