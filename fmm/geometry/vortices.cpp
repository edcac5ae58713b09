#include "fmm/geometry/vortices.hpp"

#include <cstddef>

namespace vortree::fmm {
namespace {

constexpr std::size_t many = 20000;  // blobs that threads share

}  // namespace

Unwritten<Vortex> side_by_side(const Blobs& blobs, const Units& units) {
  const std::size_t n = blobs.size();
  Unwritten<Vortex> vortices(n);
#pragma omp parallel for schedule(static) if (n > many)
  for (std::size_t i = 0; i < n; ++i) {
    vortices[i] = {units.position(blobs.x[i]), units.position(blobs.y[i]),
                   units.circulation(blobs.gamma[i]),
                   blobs.sigma.empty() ? 0.0 : units.squared_core(blobs.sigma[i])};
  }
  return vortices;
}

}  // namespace vortree::fmm
