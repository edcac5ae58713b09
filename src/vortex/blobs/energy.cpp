#include "vortex/blobs/energy.hpp"

#include <cmath>
#include <numbers>

#include "vortex/cores/halves.hpp"

namespace vortree::vortex {
namespace {

/// ln r + E_1(r^2/s^2)/2
double potential(double r2, double s2) {
  const double q = r2 / s2;
  if (q > 36) return 0.5 * std::log(r2);  // E_1(36) = 6e-18
  if (q < 1e-12) return 0.5 * (std::log(s2) - std::numbers::egamma + q);
  return 0.5 * (std::log(r2) - std::expint(-q));
}

}  // namespace

Energy energy(const Blobs& whole) {
  const Blobs blobs = Halves(whole).parts;
  const auto n = static_cast<std::ptrdiff_t>(blobs.size());
  std::vector<double> stream(n), peak(n);  // a sum a blob: the same for any number of threads
#pragma omp parallel for schedule(dynamic, 16)
  for (std::ptrdiff_t i = 0; i < n; ++i)
    for (std::ptrdiff_t j = i; j < n; ++j) {
      const Vec2 d = blobs.centre(i) - blobs.centre(j);
      const double r2 = dot(d, d),
                   s2 = blobs.sigma[i] * blobs.sigma[i] + blobs.sigma[j] * blobs.sigma[j];
      const double g = (i == j ? 1 : 2) * blobs.gamma[j];
      stream[i] += g * potential(r2, s2);
      if (r2 < 40 * s2) peak[i] += g * std::exp(-r2 / s2) / s2;
    }
  Energy sum{};
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    sum.energy -= 0.25 * std::numbers::inv_pi * blobs.gamma[i] * stream[i];
    sum.enstrophy += std::numbers::inv_pi * blobs.gamma[i] * peak[i];
  }
  return sum;
}

}  // namespace vortree::vortex
