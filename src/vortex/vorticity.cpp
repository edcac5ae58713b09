#include "vortex/vorticity.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "vortex/bins.hpp"
#include "vortex/folded_core.hpp"

namespace vortree::vortex {
namespace {

constexpr double shown = 4.8;  // cores; exp(-4.8^2) = 1e-10

/// The blobs and the mirror images of those whose cores reach into the body, sorted by place.
Blobs with_images(const Blobs& blobs, const Shape* wall) {
  Blobs all = blobs;
  for (std::size_t i = 0; wall && i < blobs.size(); ++i) {
    const WallPoint w = wall->nearest(blobs.centre(i));
    if (folded::applies(w.distance, blobs.sigma[i]))
      all.append(blobs.centre(i) - (2 * w.distance) * w.normal, blobs.gamma[i], blobs.sigma[i]);
  }
  return all;
}

}  // namespace

void vorticity(const Blobs& blobs, const Shape* wall, tree::Points at, std::span<double> omega) {
  std::ranges::fill(omega, 0.0);
  if (blobs.size() == 0) return;
  const Blobs all = with_images(blobs, wall);
  const double reach = shown * std::ranges::max(all.sigma);
  const Bins bins(all.x, all.y, reach / 2);
  const auto n = static_cast<std::ptrdiff_t>(at.size());
#pragma omp parallel for schedule(dynamic, 64)
  for (std::ptrdiff_t t = 0; t < n; ++t) {
    const Vec2 here{at.x[t], at.y[t]};
    if (wall && wall->nearest(here).distance < 0) continue;
    bins.runs_near(here, reach, [&](std::uint32_t first, std::uint32_t last) {
      for (std::uint32_t k = first; k < last; ++k) {
        const std::uint32_t j = bins.order()[k];
        const Vec2 d = here - all.centre(j);
        const double s2 = all.sigma[j] * all.sigma[j];
        omega[t] += all.gamma[j] * std::numbers::inv_pi / s2 * std::exp(-dot(d, d) / s2);
      }
    });
  }
}

}  // namespace vortree::vortex
