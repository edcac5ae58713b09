#pragma once

#include <memory>
#include <span>
#include <vector>

#include "fmm/plan.hpp"

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

/// How Biot-Savart sums are done. The solver cannot tell a fast method from the direct sum.
class Velocity {
 public:
  virtual ~Velocity() = default;

  /// Blobs upon themselves (cored), and the same circulations without cores upon other points:
  /// what a step asks of the vorticity, in one evaluation.
  virtual void upon_itself_and(const fmm::Blobs& blobs, tree::Points bare_targets,
                               Velocities& upon_blobs, Velocities& upon_targets) const = 0;

  /// The same, and how the velocity changes from place to place around each blob. At its middle a
  /// blob turns by its own core.
  virtual void upon_itself_and(const fmm::Blobs& blobs, tree::Points bare_targets,
                               Velocities& upon_blobs, Gradients& at_blobs,
                               Velocities& upon_targets) const = 0;

  /// Sources upon some points without their cores, and upon others with them.
  virtual void upon_both(const fmm::Blobs& sources, tree::Points bare_targets, Velocities& bare,
                         tree::Points targets, Velocities& cored) const = 0;

  /// Sources upon other points.
  virtual void upon(const fmm::Blobs& sources, tree::Points targets, Velocities& u) const = 0;
};

std::unique_ptr<Velocity> velocity_by_plan(const fmm::Options& options);
std::unique_ptr<Velocity> velocity_by_direct_sum(fmm::Cores cores);

}  // namespace vortree::vortex
