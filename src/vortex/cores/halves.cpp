#include "vortex/cores/halves.hpp"

#include <algorithm>
#include <cmath>

namespace vortree::vortex {
namespace {

bool acts_as_two(const Core& core) {
  return 2 * core.deviator.size() >= Halves::round * core.square;
}

}  // namespace

Vec2 to_half(const Deviator& d) {
  const double size = d.size();
  return {std::sqrt(std::max(size + d.xx, 0.0)),
          std::copysign(std::sqrt(std::max(size - d.xx, 0.0)), d.xy)};
}

Halves::Halves(const Blobs& blobs) : first(blobs.size() + 1) {
  const std::ptrdiff_t n = std::ssize(blobs.x);
  for (std::ptrdiff_t i = 0; i < n; ++i)
    first[i + 1] = first[i] + (acts_as_two(blobs.core(i)) ? 2 : 1);
  parts.resize(first[n]);
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const Core core = blobs.core(i);
    const std::uint32_t at = first[i];
    if (!halved(i)) {
      parts.put(at, blobs.centre(i), blobs.gamma[i], {core.square});
      parts.sigma[at] = blobs.sigma[i];
      continue;
    }
    const Vec2 d = to_half(core.deviator);
    const Core half{std::max(core.square - 2 * core.deviator.size(), thinnest * core.square)};
    parts.put(at, blobs.centre(i) + d, blobs.gamma[i] / 2, half);
    parts.put(at + 1, blobs.centre(i) - d, blobs.gamma[i] / 2, half);
  }
}

}  // namespace vortree::vortex
