#pragma once

#include <optional>
#include <vector>

#include "body/bodies.hpp"
#include "flow/paths/pictures.hpp"

namespace vortree::flow {

/// The velocity of a picture anywhere in its window.
///
/// Away from bodies bicubic: in either direction the cubic through four points of the grid, two on
/// either side, at an edge of the window the last four. Pictures know nothing of what is within a
/// body. So nearer to a wall than
///
///   d = 2 sqrt(2) spacing,
///
/// the farthest point of the sixteen, the velocity is the parabola along the normal through that of
/// the wall itself and those at d and 2 d from it: at the wall tracers stick to it, whatever the
/// picture has inside.
///
/// error  O(spacing^4), beside a wall O(spacing^3)
/// cost   16 multiplications a component; beside a wall three times that, and a search for the
///        nearest place of the wall
class VelocityAnywhere {
 public:
  /// bodies  as they are in the pictures, which are drawn in the frame of a body that plunges: they
  ///         stand still, or turn about their centres
  /// throws  std::invalid_argument for a grid with fewer than four points in a row or a column
  VelocityAnywhere(const PictureGrid& grid, body::Bodies bodies);

  /// Nothing outside the window, within a body, or beside a wall that the window cuts.
  [[nodiscard]] std::optional<Vec2> operator()(const VelocityPicture& picture, Vec2 at) const;

  [[nodiscard]] const PictureGrid& grid() const { return grid_; }

 private:
  struct Nearest {
    const body::Body* body;
    body::WallPoint wall;
  };
  bool inside_window(Vec2 at) const;
  bool near_wall(Vec2 at) const;
  std::optional<Nearest> nearest_wall(Vec2 at) const;
  std::optional<Vec2> beside(const VelocityPicture&, Vec2 at, const Nearest&) const;
  Vec2 bicubic(const VelocityPicture&, Vec2 at) const;

  PictureGrid grid_;
  body::Bodies bodies_;
  double layer_;                 // d
  std::vector<char> near_wall_;  // of each point of the grid: a cell at it may reach the layer
};

}  // namespace vortree::flow
