#pragma once

#include <vector>

namespace vortree::vortex {

/// Velocities as two columns [m/s].
struct Velocities {
  std::vector<double> u, v;
  explicit Velocities(std::size_t n = 0) : u(n), v(n) {}
};

/// Their gradients as three columns [1/s]: du/dx, du/dy, dv/dx; dv/dy = -du/dx.
struct Gradients {
  std::vector<double> ux, uy, vx;
  explicit Gradients(std::size_t n = 0) : ux(n), uy(n), vx(n) {}
};

}  // namespace vortree::vortex
