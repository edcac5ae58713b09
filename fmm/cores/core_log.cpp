#include <cmath>
#include <cstddef>
#include <numbers>

#include "fmm/cores/core_log_kernel.hpp"

namespace vortree::fmm {
namespace {

constexpr long double euler = std::numbers::egamma_v<long double>;

/// E1(q) = exp(-q)/(q + 1 - 1/(q + 3 - 4/(q + 5 - ...))), from the far end. n steps leave about
/// exp(-4 (n q)^(1/2)) of it.
long double exponential_integral(long double q) {
  long double rest = 0;
  for (int n = 10 + static_cast<int>(130 / q); n >= 1; --n) {
    rest = static_cast<long double>(n) * n / (q + 2 * n + 1 - rest);
  }
  return std::exp(-q) / (q + 1 - rest);
}

constexpr int most_derivatives = 24;
using Derivatives = std::array<long double, most_derivatives>;

/// A_n(q) by (n + 1) A_n = q A_(n+1) + exp(-q), downward, where nothing cancels.
Derivatives moments(long double q) {
  Derivatives a{};
  long double next = 0;
  for (int n = most_derivatives + 60 + 2 * static_cast<int>(q); n >= 0; --n) {
    next = (q * next + std::exp(-q)) / (n + 1);
    if (n < most_derivatives) a[static_cast<std::size_t>(n)] = next;
  }
  return a;
}

}  // namespace

long double core_log_plain(long double q) {
  if (q >= 2) return std::log(q) + exponential_integral(q);
  long double sum = -euler, power = 1;
  for (int k = 1; k < 40; ++k) {
    power *= -q / k;
    sum -= power / k;
  }
  return sum;
}

const CoreLog& CoreLog::table() {
  static const CoreLog made;
  return made;
}

CoreLog::CoreLog() {
  for (int node = 0; node < nodes; ++node) {
    const long double q = static_cast<long double>(node) / per_unit;
    const Derivatives a = moments(q);
    auto& series = series_[static_cast<std::size_t>(node)];
    series[0] = static_cast<double>(core_log_plain(q));
    long double factor = 1;
    for (std::size_t n = 1; n < terms; ++n) {
      factor /= static_cast<long double>(n);
      series[n] = static_cast<double>((n % 2 == 1 ? factor : -factor) * a[n - 1]);
    }
  }
}

}  // namespace vortree::fmm
