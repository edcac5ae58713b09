#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "fmm/near/p2p_kernel.hpp"
#include "fmm/sources.hpp"

namespace vortree::test {

/// Velocities by long double sums over every pair, and the local sum of |contributions|.
struct Exact {
  std::vector<long double> u, v, contributions;
};

/// Products and sums are long double; 1 - exp(-q) is as exact as double, and is 1 beyond q = 60.
inline long double exact_weight(long double r2, long double gamma, long double core) {
  return fmm::pair_weight_plain(r2, gamma, r2 < 60 * core ? core : 0.0L);
}

inline Exact exact_velocity(const fmm::Sources& blobs, const fmm::Targets& targets,
                            fmm::Cores cores) {
  const auto square = [](std::span<const double> sigma, std::size_t i) -> long double {
    return sigma.empty() ? 0.0L : static_cast<long double>(sigma[i]) * sigma[i];
  };
  Exact exact;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    long double u = 0, v = 0, contributions = 0;
    for (std::size_t j = 0; j < blobs.size(); ++j) {
      const long double dx = static_cast<long double>(targets.x[i]) - blobs.x[j];
      const long double dy = static_cast<long double>(targets.y[i]) - blobs.y[j];
      const long double r2 = dx * dx + dy * dy;
      const long double own = square(blobs.sigma, j);
      const long double core =
          cores == fmm::Cores::source ? own : (own + square(targets.sigma, i)) / 2;
      const long double w = exact_weight(r2, blobs.gamma[j], core);
      u -= w * dy;
      v += w * dx;
      contributions += std::abs(w) * std::sqrt(r2);
    }
    const long double scale = 1 / (2 * std::numbers::pi_v<long double>);
    exact.u.push_back(u * scale);
    exact.v.push_back(v * scale);
    exact.contributions.push_back(contributions * scale);
  }
  return exact;
}

struct Error {
  double relative_l2;   // ||u - exact||_2 / ||exact||_2
  double percentile99;  // of |u - exact| / sum |contributions|
  double largest;       // the same, at the worst target
};

/// u and v at the targets that `exact` holds.
inline Error error_of(std::span<const double> u, std::span<const double> v, const Exact& exact) {
  long double wrong = 0, whole = 0;
  std::vector<double> local;
  for (std::size_t i = 0; i < u.size(); ++i) {
    const long double du = u[i] - exact.u[i], dv = v[i] - exact.v[i];
    wrong += du * du + dv * dv;
    whole += exact.u[i] * exact.u[i] + exact.v[i] * exact.v[i];
    if (exact.contributions[i] > 0) {
      local.push_back(static_cast<double>(std::hypot(du, dv) / exact.contributions[i]));
    }
  }
  std::ranges::sort(local);
  return {static_cast<double>(std::sqrt(wrong / whole)),
          local.empty() ? 0.0 : local[local.size() * 99 / 100], local.empty() ? 0.0 : local.back()};
}

/// Every `stride`-th value: the sets are shuffled, so these are random targets.
inline std::vector<double> every(std::size_t stride, std::span<const double> values) {
  std::vector<double> some;
  for (std::size_t i = 0; i < values.size(); i += stride) some.push_back(values[i]);
  return some;
}

}  // namespace vortree::test
