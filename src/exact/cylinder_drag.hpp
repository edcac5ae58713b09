#pragma once

namespace vortree::exact {

/// Drag coefficient of the impulsively started circular cylinder at short times,
///
///   C_D = 4 sqrt(pi/(Re_R T)) + 2 pi/Re_R - sqrt(pi T)/Re_R^1.5 + ...,   Re_R = U R/nu, T = U t/R.
///
/// good to about 1 % while T < 0.2 at Re_R = 275
/// source  Bar-Lev & Yang, J. Fluid Mech. 72 (1975)
double short_time_cylinder_drag(double reynolds_of_radius, double time);

}  // namespace vortree::exact
