#pragma once

namespace vortree::exact {

/// Drag coefficient of the impulsively started circular cylinder at short times,
///
///   C_D = 4 sqrt(pi/(Re_R T)) + 2 pi/Re_R - sqrt(pi T)/Re_R^1.5 + ...,   Re_R = U R/nu, T = U t/R.
///
/// error   what convection adds, for 2 Re_R from 20 to 9500: 1 % at T = 0.1, 0.4 % of the mean
///         until then, 3.7 % at T = 0.2 (tests/checks/start.cpp)
/// source  Bar-Lev & Yang, J. Fluid Mech. 72 (1975)
double short_time_cylinder_drag(double reynolds_of_radius, double time);

}  // namespace vortree::exact
