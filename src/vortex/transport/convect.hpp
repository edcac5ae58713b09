#pragma once

#include <functional>
#include <utility>

#include "flow/settings.hpp"
#include "vortex/blobs/velocities.hpp"
#include "vortex/cores/folded_centroid.hpp"

namespace vortree::vortex {

/// The velocity that advects blobs where they act, so long after the beginning of the step, and its
/// gradient there, if wanted. (Circulations are the blobs'; `folded` has gone on.)
using AdvectingVelocity = std::function<Velocities(const Blobs& blobs, const FoldedBlobs& folded,
                                                   double after, Gradients* gradients)>;

/// By how much the axes in which positions and velocities are told have turned, anticlockwise, so
/// long after the beginning of the step; empty: they do not.
using TurningAxes = std::function<double(double after)>;

/// A wall so long after the beginning of the step.
///
/// at      none: free space
/// turned  by how much the body that has this arc has turned in the axes since the beginning
class WallOnItsWay {
 public:
  /// One that stands still.
  WallOnItsWay(const body::Shape* still = nullptr)
      : at_([still](double) { return still; }), turned_([](double, double) { return 0.0; }) {}
  WallOnItsWay(std::function<const body::Shape*(double after)> at,
               std::function<double(double arc, double after)> turned)
      : at_(std::move(at)), turned_(std::move(turned)) {}

  const body::Shape* at(double after) const { return at_(after); }
  double turned(double arc, double after) const { return turned_(arc, after); }

 private:
  std::function<const body::Shape*(double)> at_;
  std::function<double(double, double)> turned_;
};

/// Moves blobs for a time dt.
///
///   d X_i/dt = u(X_i),   X_i the folded centroid of blob i
///   d V_i/dt = G V_i + V_i G^T,   V_i its covariance, G = grad u at X_i, if it `strains`
///
/// Next to a wall the mean and the covariance of the folded core are moved, and the core put back
/// around them; on the way its covariance stays as it is. (Strained cores of free space:
/// convect_strained.hpp.) Without strain a blob is a rigid disc: an error of V : grad grad omega,
/// first order in sigma^2.
///
/// Velocities are those of axes at rest, told in axes that may turn: what is far goes round as
/// exactly as it stands.
/// error   O(dt^2) for rk2, O(dt^4) for rk4, per unit of time; O(dt^2) of the covariance
/// cost    two, or four, evaluations of the velocity, one with the gradient
///
/// found    wall points nearest to the centres
/// axes     with those of the wall
/// returns  those nearest to where they have come to, as far as they were needed
WallPoints convect(Blobs& blobs, const AdvectingVelocity& velocity, const WallOnItsWay& wall,
                   flow::Scheme scheme, double dt, bool strains = false,
                   const WallPoints& found = WallPoints(), const TurningAxes& axes = {});

}  // namespace vortree::vortex
