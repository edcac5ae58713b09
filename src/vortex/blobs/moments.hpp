#pragma once

#include "vortex/blobs/blobs.hpp"

namespace vortree::vortex {

/// Moments of the vorticity of free space, which tell its shape.
///
/// positive       sum of the positive gamma [m^2/s], and where its centre is
/// quadrupole     (int omega (x^2 - y^2) dA, int omega 2 x y dA) about the centre of vorticity
///                [m^4/s]; its argument is twice the tilt of the major axis
/// separation     of two vortices [m]: twice the mean distance of the vorticity from the line
///                through the centre across the major axis (for two equal vortices, that of the
///                centres of the halves); of opposite ones, whose gamma cancel, the distance of
///                their centres
/// cost           O(blobs)
struct Moments {
  double positive;
  Vec2 positive_centre;
  Vec2 quadrupole;
  double separation;
};

Moments moments(const Blobs& blobs);

}  // namespace vortree::vortex
