#pragma once

#include <deque>
#include <memory>
#include <utility>
#include <vector>

#include "body/motion.hpp"
#include "vortex/wall/turning.hpp"

namespace vortree::vortex {

/// Bodies as they stand at one time, and what goes with their turning, or none if none turns.
struct Standing {
  Wall wall;
  std::vector<Turning> turning;
};

/// The wall of bodies as seen from a frame, in which they may move against each other.
///
/// cost  where any moves or turns out of its place, a wall anew for each time that is asked for and
///       not among the last four: 2/3 panels^3 operations, 9 ms of 400 panels, 0.1 s of 1000; else
///       once
class MovingWall {
 public:
  /// bodies  each as seen from its own centre, which stands at `centre` as long as it has not moved
  /// own     motion of each in the frame
  /// turns   with the frame
  MovingWall(std::vector<WallBody> bodies, std::vector<body::Motion> own, bool turns);

  /// A single one, which stands in the frame's origin and may turn with it.
  MovingWall(std::shared_ptr<const body::Shape> shape, int panels, bool turns = false)
      : MovingWall({{std::move(shape), panels}}, {{}}, turns) {}

  std::size_t panels() const;
  double perimeter() const;  ///< of all bodies
  std::shared_ptr<const Standing> at(double time) const;

 private:
  std::shared_ptr<const Standing> made(double time) const;

  std::vector<WallBody> bodies_;
  std::vector<body::Motion> own_;
  std::vector<Turning> alone_;  // of each body in its own axes
  bool moves_ = false;
  mutable std::deque<std::pair<double, std::shared_ptr<const Standing>>> recent_;
};

}  // namespace vortree::vortex
