#pragma once

#include <span>
#include <vector>

#include "fmm/plan.hpp"
#include "vortex/step.hpp"

namespace vortree::vortex {

/// What surrounds the blobs at one time: the stream, how fast each body turns, and how it goes in
/// the frame.
struct Around {
  Vec2 stream;
  std::vector<double> rates;     // none where no body turns
  std::vector<Vec2> velocities;  // of several bodies

  Around(const Problem& p, double time);
  double circulation_of_bodies(const Problem& p) const;
};

/// Adds weight times each value.
void add(std::vector<double>& sum, double weight, std::span<const double> of);

void add_stream(Velocities& u, Vec2 stream);
void append(Blobs& blobs, const Blobs& more);

/// Blobs that have left the box and are felt; and the others with these after them.
Blobs felt(const Problem& p);
Blobs with_drifting(const Blobs& blobs, const Problem& p);

fmm::Sources as_sources(const Blobs& blobs, const FoldedBlobs& at);

/// A point has no core of its own that could enter a mean.
fmm::Options at_points(fmm::Options sums);

/// The sheet that moves fluid, and with it those of bodies that turn.
std::vector<double> with_turning(std::vector<double> sheet, const Problem& p, const Around& around);

/// Velocity of the blobs at their folded centroids, with stream and wall; and its gradient, if
/// wanted, without the sheet's.
Velocities advecting_velocity(const Blobs& blobs, const FoldedBlobs& at, const Problem& p,
                              double time, Gradients* gradients);

/// Slip at the wall, the sheet that cancels it there, and velocities at points of the fluid.
struct AtRest {
  std::vector<double> slip, sheet;
  Velocities u;
};

/// The sheet that cancels the slip which the blobs leave at the wall, and the velocity of stream,
/// blobs and sheet together.
///
/// at_once  bodies that turn have begun to at this very time
AtRest with_sheet(tree::Points points, const Blobs& blobs, const FoldedBlobs& at, const Problem& p,
                  double time, bool at_once = false);

}  // namespace vortree::vortex
