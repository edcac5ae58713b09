#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "tree/base/buffer.hpp"
#include "tree/base/simd.hpp"

namespace vortree::tree {

/// Particles in the order in which they are searched: those of one cell, and cells that lie
/// together, one after the other.
///
/// x, y, reach   [m]
/// id            position in the input
/// Behind the last particle is room for a register more to be read.
struct SortedParticles {
  Buffer<double> x, y, reach;
  Buffer<std::int32_t> id;
  std::size_t size = 0;

  void renew(std::size_t n) {
    size = n;
    for (Buffer<double>* values : {&x, &y, &reach}) {
      values->renew(n + single_count);
      std::fill_n(values->data() + n, single_count, 0.0);
    }
    id.renew(n + single_count);
    std::fill_n(id.data() + n, single_count, -1);
  }
};

}  // namespace vortree::tree
