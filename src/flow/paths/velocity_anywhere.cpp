#include "flow/paths/velocity_anywhere.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

namespace vortree::flow {
namespace {

constexpr int stencil = 4;

/// Four points of one axis, and what each of them counts.
struct FourPoints {
  int first;
  std::array<double, stencil> weight;
};

/// place  along the axis, in spacings from its first point
FourPoints four_around(double place, int points) {
  const int first = std::clamp(static_cast<int>(place) - 1, 0, points - stencil);
  const double s = place - first, a = s - 1, b = s - 2, c = s - 3;
  return {first, {-a * b * c / 6, s * b * c / 2, -s * a * c / 2, s * a * b / 6}};
}

Vec2 velocity_of_wall(const body::Body& body, Vec2 from_centre) {
  const double rate = body.motion.spin.rate + body.own.spin.rate;
  return {-rate * from_centre.y, rate * from_centre.x};
}

}  // namespace

VelocityAnywhere::VelocityAnywhere(const PictureGrid& grid, body::Bodies bodies)
    : grid_(grid),
      bodies_(std::move(bodies)),
      layer_(2 * std::numbers::sqrt2 * grid.spacing),
      near_wall_(grid.points()) {
  if (grid.columns < stencil || grid.rows < stencil)
    throw std::invalid_argument(std::to_string(grid.columns) + " x " + std::to_string(grid.rows) +
                                " points; bicubic interpolation needs 4 x 4");
  // No place of a cell is farther from the cell's first point than its diagonal.
  const double reach = layer_ + std::numbers::sqrt2 * grid.spacing;
  for (const body::Body& body : bodies_)
    for (std::size_t k = 0; k < near_wall_.size(); ++k) {
      const auto row = static_cast<int>(k / grid.columns),
                 column = static_cast<int>(k % grid.columns);
      const Vec2 at = grid.point(row, column) - body.centre;
      if (!body.shape->beyond(at, reach) && body.shape->distance(at) < reach) near_wall_[k] = 1;
    }
}

bool VelocityAnywhere::inside_window(Vec2 at) const {
  const Vec2 last = grid_.point(grid_.rows - 1, grid_.columns - 1);
  return at.x >= grid_.first.x && at.x <= last.x && at.y >= grid_.first.y && at.y <= last.y;
}

bool VelocityAnywhere::near_wall(Vec2 at) const {
  const Vec2 place = (1 / grid_.spacing) * (at - grid_.first);
  const int column = std::min(static_cast<int>(place.x), grid_.columns - 1),
            row = std::min(static_cast<int>(place.y), grid_.rows - 1);
  return near_wall_[static_cast<std::size_t>(row) * grid_.columns + column];
}

std::optional<VelocityAnywhere::Nearest> VelocityAnywhere::nearest_wall(Vec2 at) const {
  std::optional<Nearest> found;
  for (const body::Body& body : bodies_) {
    const body::WallPoint wall = body.shape->nearest(at - body.centre);
    if (!found || wall.distance < found->wall.distance) found = {&body, wall};
  }
  return found;
}

/// The parabola a s + b s^2, s the distance from the wall in layers, over the wall's velocity.
std::optional<Vec2> VelocityAnywhere::beside(const VelocityPicture& picture, Vec2 at,
                                             const Nearest& nearest) const {
  const auto& [body, wall] = nearest;
  const Vec2 foot = at - wall.distance * wall.normal, near = foot + layer_ * wall.normal,
             far = foot + 2 * layer_ * wall.normal;
  if (!inside_window(near) || !inside_window(far)) return std::nullopt;
  const Vec2 still = velocity_of_wall(*body, foot - body->centre),
             one = bicubic(picture, near) - still, two = bicubic(picture, far) - still;
  const double s = wall.distance / layer_;
  return still + s * (2 - s) * one + s * (s - 1) / 2 * two;
}

Vec2 VelocityAnywhere::bicubic(const VelocityPicture& picture, Vec2 at) const {
  const Vec2 place = (1 / grid_.spacing) * (at - grid_.first);
  const FourPoints x = four_around(place.x, grid_.columns), y = four_around(place.y, grid_.rows);
  Vec2 sum;
  for (int j = 0; j < stencil; ++j) {
    const Vec2* row =
        &picture.velocity[static_cast<std::size_t>(y.first + j) * grid_.columns + x.first];
    Vec2 along;
    for (int i = 0; i < stencil; ++i) along += x.weight[i] * row[i];
    sum += y.weight[j] * along;
  }
  return sum;
}

std::optional<Vec2> VelocityAnywhere::operator()(const VelocityPicture& picture, Vec2 at) const {
  if (!inside_window(at)) return std::nullopt;  // nor is nan
  if (!near_wall(at)) return bicubic(picture, at);
  const auto nearest = nearest_wall(at);
  if (nearest && nearest->wall.distance < 0) return std::nullopt;
  if (nearest && nearest->wall.distance < layer_) return beside(picture, at, *nearest);
  return bicubic(picture, at);
}

}  // namespace vortree::flow
