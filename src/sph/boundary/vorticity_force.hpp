#pragma once

#include <vector>

#include "body/shape.hpp"
#include "sph/boundary/biot_savart.hpp"
#include "sph/boundary/unit_potential.hpp"

namespace vortree::sph {

/// The force of the pressure on a body, per unit density, from velocity and vorticity of one time:
/// no pressure is asked for, no rate of change taken. The momentum equation, weighted by the
/// gradient of a unit potential phi and integrated over all fluid, leaves along e
///
///   F.e = int omega (v phi_x - u phi_y) dA - nu oint omega dphi/ds ds - A.dipole
///
/// in the frame of a body with the acceleration A, whose own part, area A, is still to be added
/// (body/motion.hpp); its rate of change of impulse, worked out. Vorticity far away counts as
/// 1/r^2. The layer between the wall and the first particles, which stand a spacing h off it, adds
/// h^2/12 oint omega^2 n ds to the sum over particles.
///
/// error    O(h^2) of the wall vorticity and of velocities
/// cost     O(n): of each vortex two sums of UnitPotentials
/// source   Quartapelle & Napolitano, AIAA J. 21 (1983); Chang, Proc. R. Soc. A 437 (1992)
class VorticityForce {
 public:
  VorticityForce() = default;

  /// wall   nodes of it, at equal steps of the arc, the first half a step from its beginning
  VorticityForce(const body::Shape& shape, const std::vector<Vec2>& wall);

  /// far_field       all vortices
  /// wall_vorticity  of each node [1/T]
  /// nu              kinematic viscosity [L^2/T]
  /// acceleration    of the frame [L/T^2]
  [[nodiscard]] Vec2 operator()(const BiotSavart& far_field,
                                const std::vector<double>& wall_vorticity, double nu,
                                Vec2 acceleration) const;

 private:
  double step_ = 0;
  std::vector<Vec2> normal_;
  std::vector<double> dphi_ds_[2];  // at its nodes, of either axis
  std::shared_ptr<const UnitPotentials> potentials_;
};

}  // namespace vortree::sph
