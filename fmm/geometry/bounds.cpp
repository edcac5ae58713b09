#include "fmm/geometry/bounds.hpp"

#include <array>
#include <cstddef>

#include "fmm/geometry/bounds_kernel.hpp"
#include "tree/base/parallel.hpp"

namespace vortree::fmm {

Bounds bounds_of(std::span<const double> values) {
  const std::size_t n = values.size();
  const std::size_t pieces = n > tree::values_worth_sharing ? tree::shared_pieces : 1;
  std::array<Bounds, tree::shared_pieces> found;
  tree::for_each_piece(pieces, [&](std::size_t p) {
    const tree::Range own = tree::piece(n, p, pieces);
    found[p] = kernel::bounds(values.subspan(own.first, own.size()));
  });
  Bounds all;
  for (const Bounds& some : found) all = kernel::united(all, some);
  return all;
}

SourceBounds SourceBounds::of(const Sources& sources) {
  return {bounds_of(sources.x), bounds_of(sources.y), bounds_of(sources.gamma),
          bounds_of(sources.sigma)};
}

}  // namespace vortree::fmm
