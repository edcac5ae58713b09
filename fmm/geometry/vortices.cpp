#include "fmm/geometry/vortices.hpp"

#include <cstddef>

#include "tree/base/parallel.hpp"

namespace vortree::fmm {

Unwritten<Vortex> side_by_side(const Sources& sources, const Units& units) {
  const std::size_t n = sources.size();
  Unwritten<Vortex> vortices(n);
  const auto put = [&](std::uint32_t i) {
    vortices[i] = {units.position(sources.x[i]), units.position(sources.y[i]),
                   units.circulation(sources.gamma[i]),
                   sources.sigma.empty() ? 0.0 : units.squared_core(sources.sigma[i])};
  };
  tree::share_evenly(tree::all_of(n), n > tree::records_worth_sharing, put);
  return vortices;
}

}  // namespace vortree::fmm
