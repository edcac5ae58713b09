#pragma once

#include <memory>
#include <optional>

#include "flow/scales.hpp"
#include "flow/solver.hpp"
#include "vortex/settings.hpp"
#include "vortex/step.hpp"

namespace vortree::vortex {

/// From where positions are counted while a flow is computed: the centre of the body, or that of
/// the initial vorticity, which goes with the stream in free space. Round-off is then that of the
/// flow's own extent, wherever it lies.
struct Origin {
  Vec2 start{}, drift{};

  Vec2 at(double t) const { return start + t * drift; }
};

/// A flow at t = 0, before any wall has released its sheet, and how it will be followed.
///
/// wall     none in free space; `problem` points at it. It, the problem and the blobs are as seen
///          from `origin`, in the axes of the body
/// box      in the scene: blobs that leave it are taken away
/// held_blobs        more the machine's memory does not hold
/// crowding          how many times the usual number of blobs mergers will leave
/// splits_endlessly  children are too wide to merge
struct Setup {
  std::shared_ptr<const MovingWall> wall{};
  Problem problem;
  Blobs blobs{};
  flow::Scales scales{};
  Origin origin{};
  std::optional<Box> box{};
  std::size_t held_blobs = flow::most_particles;
  double crowding = 1;
  bool splits_endlessly = false;
};

/// A scene as the method takes it.
Setup setup_of(const VortexCase& scene);

}  // namespace vortree::vortex
