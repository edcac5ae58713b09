#include "fmm/geometry/vortices.hpp"

#include <cstddef>

#include "tree/base/tuning.hpp"

namespace vortree::fmm {

Unwritten<Vortex> side_by_side(const Sources& sources, const Units& units) {
  const std::size_t n = sources.size();
  Unwritten<Vortex> vortices(n);
#pragma omp parallel for schedule(static) if (n > tree::records_worth_sharing)
  for (std::size_t i = 0; i < n; ++i) {
    vortices[i] = {units.position(sources.x[i]), units.position(sources.y[i]),
                   units.circulation(sources.gamma[i]),
                   sources.sigma.empty() ? 0.0 : units.squared_core(sources.sigma[i])};
  }
  return vortices;
}

}  // namespace vortree::fmm
