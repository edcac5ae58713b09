#pragma once

#include "flow/initial/settings.hpp"
#include "vortex/blobs/blobs.hpp"

namespace vortree::vortex {

/// Vorticity cut into blobs of width sigma_0 on a square lattice of step h around `centre`. Blobs
/// below `faintest` of the strongest are left out.
struct Lattice {
  Vec2 centre;
  double sigma_0, h;
  double faintest = 1e-12;
};

/// A patch of vorticity whose flow has its centre there, each blob with its weight; they hold the
/// circulation exactly.
/// error   that of the patch (flow/initial)
/// throws  std::invalid_argument unless sigma_0, h > 0
Blobs cut(const Lattice& lattice, const flow::Patch& patch);

/// An initial flow, its patches one after the other; its place, spacing and faintest are those of
/// the lattice.
Blobs cut(const Lattice& lattice, const flow::InitialSettings& initial);

/// An elliptical Gaussian of half widths a along x and b along y (flow/initial/gaussian.hpp).
/// error   O(exp(-(pi sigma_0/h)^2)) relative
/// throws  std::invalid_argument unless a, b > sigma_0 > 0 and h > 0
Blobs gaussian_ellipse(const Lattice& lattice, double gamma, double a, double b);

/// The round one: a Lamb-Oseen vortex.
Blobs gaussian_vortex(Vec2 centre, double gamma, double core, double sigma_0, double h);

/// A Gaussian vortex of width a with a quadrupole upon it, p (x^2 - y^2)/a^2 of it: a tripole.
/// error   as above
Blobs perturbed_vortex(const Lattice& lattice, double gamma, double a, double p);

/// Uniform vorticity gamma/(pi a b) within an ellipse: each blob has the share of its cell that
/// lies inside. Its edge is as wide as the blobs.
/// throws  std::invalid_argument unless a, b, sigma_0, h > 0
Blobs uniform_ellipse(const Lattice& lattice, double gamma, double a, double b);

}  // namespace vortree::vortex
