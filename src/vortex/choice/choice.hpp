#pragma once

#include "vortex/settings.hpp"

namespace vortree::vortex {

/// Fills in what a scene leaves out: from `accuracy` whatever of cores, time step, merging,
/// velocity tolerance and panels is not written.
///
/// With a body of diameter D in a stream U (sqrt(U^2 + V^2) for one that plunges with speeds up to
/// V), accuracy e the drag's relative error from T = 0.2 on (measured from Re = 1 to 9500,
/// cases/accuracy.md):
///
///   sigma_max = 4 sqrt(e nu D/U)            cores as a share of the boundary layer, at most
///                                           sqrt((6 + 2 q) nu dt), that they split before strain
///                                           has drawn them out, and not below the sqrt(4 nu dt)
///                                           that a step adds
///                                           (beside the body no wider than at Re = 20, or D/4)
///   dt        = min(2 e, 0.02 (e/0.01)^(1/3) sqrt(550/Re)) D/U     q <= 1: the second of these as
///                                           a share of the first. So the wall's vorticity turns
///                                           by 0.94 (e/0.01)^(1/3) rad, which errs by its square
///                                           at first, and no more than with e = 0.05. Around a
///                                           tip of less than D/10 strain draws cores out: there
///                                           the root is 1 at most, and cores are sqrt(8 nu dt)
///                                           (e/0.01)^(1/4) beyond e = 0.01, lest they multiply.
///                                           A motion has 100 sqrt(0.02/e) steps a period, 100 at
///                                           least (of plunging_naca0012_k8 at e = 0.01 the drag's
///                                           two routes are 3.2 % apart by 142, 5.2 % by 100); at
///                                           most 0.1 min(e, 0.05) D^2/nu, that cores stay as small
///                                           against the body as they are at Re = 20; here and
///                                           below a little less, so that time.end is met
///                                           (flow/steps.hpp)
///   sigma_0   = sqrt(2 nu dt)               panels: 2.4 sigma_0 long on the circle around the
///                                           body, and shorter where it bends or is thin, one and a
///                                           half as many as needed there at least
///                                           (body/outlines/panel_limits.hpp), 128 to 4000 of them
///   merging.tolerance = 4 e U               beside the wall, where forces come from, hardly
///                                           anything merges: drag is the same to a tenth of e with
///                                           a quarter of it, for an eighth more blobs
///   merging.reach = 3,  merging.cap = 1.2
///   velocity.tolerance = e/1000,  velocity.cores = "both"
///
/// In free space, with L the least width and omega the mean vorticity of the initial vortex, e the
/// relative error of its quadrupole:
///
///   sigma_max = 0.55 L e^(1/4)      cores are strained (scales.hpp): second order in sigma^2, so
///                                   that the tripole, whose arms are thinner than L, has 10, 3.0
///                                   and 0.91 % at e = 0.1, 0.03 and 0.01; gaussian_ellipse has
///                                   0.06 % at 0.1, corotating_pair 0.35 %
///               1.2 L sqrt(e)       cores stay round: first order, as gaussian_ellipse has it
///   sigma_0   = sigma_max/1.3
///   dt = min(0.4/omega, sigma_max^2/(4 nu)), so that a step widens cores no more than splitting
///   makes up for,
///   merging.tolerance = 0.02 e L omega,  velocity.tolerance = e/1000
///
/// Steps, cores and levels of the lattices that wide blobs are laid onto follow from sigma_max and
/// dt (vortex/adapt/lattice/laying.hpp).
///
/// throws  Refused if a needed key is neither written nor chosen, and for an initial flow that
///         fills the plane
void choose_missing(flow::Case& of, VortexSettings& own, const flow::Written& written);

}  // namespace vortree::vortex
