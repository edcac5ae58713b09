#include "fmm/geometry/vortices.hpp"

#include <cstddef>

#include "tree/base/tuning.hpp"

namespace vortree::fmm {

Unwritten<Vortex> side_by_side(const Blobs& blobs, const Units& units) {
  const std::size_t n = blobs.size();
  Unwritten<Vortex> vortices(n);
#pragma omp parallel for schedule(static) if (n > tree::records_worth_sharing)
  for (std::size_t i = 0; i < n; ++i) {
    vortices[i] = {units.position(blobs.x[i]), units.position(blobs.y[i]),
                   units.circulation(blobs.gamma[i]),
                   blobs.sigma.empty() ? 0.0 : units.squared_core(blobs.sigma[i])};
  }
  return vortices;
}

}  // namespace vortree::fmm
