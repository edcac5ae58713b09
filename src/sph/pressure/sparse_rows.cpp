#include "sph/pressure/sparse_rows.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace vortree::sph {
namespace {

constexpr std::size_t worth_sharing = 8192;  // rows

[[noreturn]] void refuse(const std::string& what) {
  throw std::invalid_argument("sparse rows: " + what);
}

void check_sizes(const SparseRows& a) {
  const std::size_t n = a.size(), values = a.value.size();
  if (a.start.size() != n + 1 || a.index.size() != values)
    refuse(std::to_string(n) + " rows with " + std::to_string(a.start.size()) + " starts, " +
           std::to_string(a.index.size()) + " indices and " + std::to_string(values) + " values");
  if (a.start.front() != 0 || a.start.back() != static_cast<std::int64_t>(values))
    refuse("from " + std::to_string(a.start.front()) + " to " + std::to_string(a.start.back()) +
           ", but there are " + std::to_string(values) + " values");
  for (std::size_t i = 0; i < n; ++i)
    if (a.start[i] > a.start[i + 1])
      refuse("row " + std::to_string(i) + " of " + std::to_string(n) + " from " +
             std::to_string(a.start[i]) + " to " + std::to_string(a.start[i + 1]));
}

// Is there anything to refuse? Sums of products with zero tell without a branch.
bool row_is_sound(const SparseRows& a, std::size_t i) {
  const auto n = static_cast<std::uint32_t>(a.size());
  bool outside = false;
  double zero = 0 * a.diagonal[i];
  for (std::int32_t k = a.start[i]; k < a.start[i + 1]; ++k) {
    outside |= static_cast<std::uint32_t>(a.index[k]) >= n;
    outside |= a.index[k] == static_cast<std::int32_t>(i);
    zero += 0 * a.value[k];
  }
  return !outside && zero == 0 && a.diagonal[i] != 0;
}

void check_finite(const char* name, std::span<const double> numbers) {
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (!std::isfinite(numbers[i]))
      refuse(std::string(name) + "[" + std::to_string(i) + "] is " + std::to_string(numbers[i]));
}

}  // namespace

void check(const SparseRows& a) {
  check_sizes(a);
  std::size_t sound = a.size();  // rows before the first that is not
#pragma omp parallel for schedule(static) reduction(min : sound) if (a.size() > worth_sharing)
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!row_is_sound(a, i)) sound = std::min(sound, i);
  if (sound < a.size())
    refuse("row " + std::to_string(sound) + " of " + std::to_string(a.size()) + " with diagonal " +
           std::to_string(a.diagonal[sound]) + " has an index or a value that cannot be");
}

void check_vectors(const SparseRows& a, std::span<const double> b, std::span<const double> x) {
  if (b.size() != a.size() || x.size() != a.size())
    refuse(std::to_string(a.size()) + " rows, but " + std::to_string(b.size()) + " of b and " +
           std::to_string(x.size()) + " of x");
  check_finite("b", b), check_finite("x", x);
}

}  // namespace vortree::sph
