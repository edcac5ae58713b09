#pragma once

namespace vortree::exact {

/// Two equal Gaussian vortices, or two opposite ones, a distance b apart, whose cores spread by
/// viscosity, a^2 = core^2 + 4 nu t.
///
/// Each moves with the other's velocity averaged over its own Gaussian,
///
///   speed = gamma/(2 pi b) (1 - exp(-b^2/(2 a^2))),
///
/// so that opposite ones travel at `speed` across the line between them, and equal ones circle each
/// other at 2 speed/b. Exact for round cores; the strain of the other flattens them by O(a^2/b^2),
/// which changes the speed by O(a^4/b^4).
///
/// Equal ones keep their distance until a/b reaches `onset` and then merge.
/// source  Meunier, Ehrenstein, Leweke & Rossi, Phys. Fluids 14 (2002): 0.22 +- 0.01
struct VortexPair {
  double gamma, core, distance, nu;

  static constexpr double onset = 0.22;
  double core_at(double t) const;
  double speed(double t) const;
  double travelled(double t) const;  ///< integral of the speed from 0 to t
};

}  // namespace vortree::exact
