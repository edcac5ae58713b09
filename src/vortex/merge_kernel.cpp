#include "vortex/merge_kernel.hpp"

#include <algorithm>

namespace vortree::vortex::merge_kernel {

Candidates::Candidates(const Blobs& blobs) : size(static_cast<std::uint32_t>(blobs.size())) {
  for (auto* column : {&x, &y, &gamma, &square, &inverse_cube})
    column->assign(size + Lanes::size(), never);
#pragma omp parallel for schedule(static)
  for (std::uint32_t i = 0; i < size; ++i) {
    const double s = blobs.sigma[i], g = blobs.gamma[i];
    x[i] = static_cast<float>(blobs.x[i]);
    y[i] = static_cast<float>(blobs.y[i]);
    // Quartered often enough, circulations vanish in single precision; their sign must not.
    gamma[i] = static_cast<float>(std::copysign(std::max(std::abs(g), 1e-30), g));
    square[i] = static_cast<float>(s * s);
    inverse_cube[i] = static_cast<float>(1 / (s * s * s));
  }
}

}  // namespace vortree::vortex::merge_kernel
