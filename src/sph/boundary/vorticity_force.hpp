#pragma once

#include <array>
#include <vector>

#include "body/shape.hpp"
#include "sph/boundary/biot_savart.hpp"
#include "sph/boundary/unit_potential.hpp"

namespace vortree::sph {

/// The force of the pressure on each body, per unit density, from velocity and vorticity of one
/// time: no pressure is asked for, no rate of change taken. The momentum equation, weighted by the
/// gradient of the body's unit potential phi and integrated over all fluid, leaves along e
///
///   F.e = int omega (v phi_x - u phi_y) dA - nu oint omega dphi/ds ds - A.dipole
///
/// with all walls in the integral along them, in the frame of bodies with the acceleration A, whose
/// own part, area A, is still to be added (body/motion.hpp); the sum of all is the rate of change
/// of impulse, worked out. The wall of a circle that turns adds nothing: its speed is the same all
/// around, and the pressure p + u^2/2 of the equation presses as p does. Vorticity far away counts
/// as 1/r^2. The layer between the wall and the first particles, which stand a spacing h off it,
/// adds h^2/12 oint omega^2 n ds over the body's own wall to the sum over particles: along others
/// the slope of phi has no part through the wall.
///
/// error    O(h^2) of the wall vorticity and of velocities
/// cost     O(n): of each vortex and each body two sums of UnitPotentials
/// source   Quartapelle & Napolitano, AIAA J. 21 (1983); Chang, Proc. R. Soc. A 437 (1992)
class VorticityForce {
 public:
  VorticityForce() = default;

  /// wall   nodes of it, body after body, at equal steps of the arc, the first half a step from
  ///        where the body's begins
  /// nodes  of each body
  VorticityForce(const body::Shape& shape, const std::vector<Vec2>& wall,
                 const std::vector<int>& nodes);
  /// A single body.
  VorticityForce(const body::Shape& shape, const std::vector<Vec2>& wall)
      : VorticityForce(shape, wall, {static_cast<int>(wall.size())}) {}

  /// far_field       all vortices
  /// wall_vorticity  of each node [1/T]
  /// nu              kinematic viscosity [L^2/T]
  /// acceleration    of the frame [L/T^2]
  [[nodiscard]] std::vector<Vec2> on_each(const BiotSavart& far_field,
                                          const std::vector<double>& wall_vorticity, double nu,
                                          Vec2 acceleration) const;

  /// On the first body.
  [[nodiscard]] Vec2 operator()(const BiotSavart& far_field,
                                const std::vector<double>& wall_vorticity, double nu,
                                Vec2 acceleration) const {
    return on_each(far_field, wall_vorticity, nu, acceleration).front();
  }

 private:
  [[nodiscard]] double add_along_wall(double sum, std::size_t body, UnitPotentials::Axis axis,
                                      const std::vector<double>& wall_vorticity, double nu) const;

  std::size_t bodies_ = 0;
  std::vector<Vec2> normal_;
  std::vector<double> step_;                                 // of each node
  std::vector<std::size_t> body_;                            // that it belongs to
  std::vector<std::array<std::vector<double>, 2>> dphi_ds_;  // of each body and axis, at its nodes
  std::shared_ptr<const UnitPotentials> potentials_;
};

}  // namespace vortree::sph
