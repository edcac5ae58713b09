#pragma once

#include <algorithm>
#include <array>

#include "fmm/cores/log_kernel.hpp"
#include "tree/base/simd.hpp"

namespace vortree::fmm {

/// What a Gaussian core makes of the logarithm at q = r^2/S:
///
///   ln r^2 + E1(q) = ln S + core_log(q),   core_log(q) = ln q + E1(q)
///                                                      = Ein(q) - 0.5772... ,
///   Ein(q) = int_0^q (1 - exp(-t))/t dt
///
/// which is entire in q: nothing happens at r = 0. Beyond q = bare_log E1 is below the last bit.
///
/// error   3e-16, absolute
/// twin    core_log_plain
inline constexpr double bare_log = 37;

/// A power series below q = 2, the continued fraction of E1 above.
[[nodiscard]] long double core_log_plain(long double q);

/// Taylor series of core_log about the nodes k/4. With A_n(q) = int_0^1 s^n exp(-q s) ds,
///
///   core_log(q + d) = core_log(q) + sum_{n >= 1} (-1)^(n-1) A_(n-1)(q) d^n / n!,   |d| <= 1/8
class CoreLog {
 public:
  /// Made once.
  static const CoreLog& table();

  [[nodiscard]] Lanes operator()(Lanes q) const {
    Lanes result;
    for (int i = 0; i < lane_count; ++i) result[i] = at(q[i]);
    return result;
  }

 private:
  static constexpr int per_unit = 4, terms = 10;
  static constexpr int nodes = static_cast<int>(bare_log) * per_unit + 1;

  CoreLog();
  /// q beyond bare_log gives any number.
  [[nodiscard]] double at(double q) const {
    const double bounded = std::min(q, bare_log) * per_unit;
    const int node = static_cast<int>(bounded + 0.5);
    const double d = (bounded - node) / per_unit;
    const auto& a = series_[static_cast<std::size_t>(node)];
    double value = a[terms - 1];
    for (int n = terms - 2; n >= 0; --n) value = value * d + a[n];
    return value;
  }

  std::array<std::array<double, terms>, nodes> series_;
};

}  // namespace vortree::fmm
