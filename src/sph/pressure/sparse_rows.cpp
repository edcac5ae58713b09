#include "sph/pressure/sparse_rows.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "base/ordered_sum.hpp"

namespace vortree::sph {
namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw std::invalid_argument("sparse rows: " + what);
}

void check_finite(const char* name, std::span<const double> numbers) {
  double zero = 0;
#pragma omp simd reduction(+ : zero)
  for (std::size_t i = 0; i < numbers.size(); ++i) zero += 0 * numbers[i];
  if (zero == 0) return;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (!std::isfinite(numbers[i]))
      refuse(std::string(name) + "[" + std::to_string(i) + "] is " + std::to_string(numbers[i]));
}

}  // namespace

SparseRows unsliced(const SlicedDoubles& a) {
  SparseRows made{std::vector<double>(a.rows), {0}, {}, {}};
  for (std::size_t i = 0; i < a.rows; ++i) {
    a.for_row(i, [&](std::size_t j, double value) {
      if (j == i)
        made.diagonal[i] += value;
      else
        made.index.push_back(static_cast<std::int32_t>(j)), made.value.push_back(value);
    });
    made.start.push_back(static_cast<std::int32_t>(made.index.size()));
  }
  return made;
}

void multiply(const SparseRows& a, std::span<const double> x, std::span<double> y) {
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < a.size(); ++i) {
    double sum = a.diagonal[i] * x[i];
    for (std::int32_t k = a.start[i]; k < a.start[i + 1]; ++k)
      sum += a.value[k] * x[static_cast<std::size_t>(a.index[k])];
    y[i] = sum;
  }
}

double norm(std::span<const double> a) {
  return std::sqrt(ordered_sum(a.size(), [&](std::size_t first, std::size_t last) {
    double sum = 0;
    for (std::size_t i = first; i < last; ++i) sum += a[i] * a[i];
    return sum;
  }));
}

void check_vectors(std::size_t n, std::span<const double> b, std::span<const double> x) {
  if (b.size() != n || x.size() != n)
    refuse(std::to_string(n) + " rows, but " + std::to_string(b.size()) + " of b and " +
           std::to_string(x.size()) + " of x");
  check_finite("b", b), check_finite("x", x);
}

}  // namespace vortree::sph
