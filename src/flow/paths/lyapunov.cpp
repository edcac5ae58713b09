#include "flow/paths/lyapunov.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

#include "tree/base/told.hpp"

namespace vortree::flow {
namespace {

constexpr std::size_t around = 4;  // tracers of a place: east, west, north, south

std::vector<Vec2> close_tracers(const PictureGrid& grid, double offset) {
  std::vector<Vec2> places;
  places.reserve(around * grid.points());
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      for (const Vec2 way : {Vec2{1, 0}, Vec2{-1, 0}, Vec2{0, 1}, Vec2{0, -1}})
        places.push_back(grid.point(row, column) + offset * way);
  return places;
}

/// The largest eigenvalue of F^T F, the columns of F being a and b.
double largest_stretch(Vec2 a, Vec2 b) {
  const double aa = dot(a, a), bb = dot(b, b), ab = dot(a, b);
  return (aa + bb + std::hypot(aa - bb, 2 * ab)) / 2;
}

}  // namespace

LyapunovField lyapunov(std::span<const VelocityPicture> pictures, const VelocityAnywhere& velocity,
                       const PictureGrid& grid, double offset, double from, double to) {
  if (from == to)
    throw std::invalid_argument("from t = " + tree::told(from) +
                                " to the same time nothing is drawn apart");
  const std::vector<Vec2> ends =
      flow_map(close_tracers(grid, offset), pictures, velocity, from, to);
  LyapunovField found{from, to, grid, std::vector<double>(grid.points())};
  for (std::size_t k = 0; k < found.exponent.size(); ++k) {
    const Vec2* of = &ends[around * k];
    const double scale = 1 / (2 * offset);
    const double stretch = largest_stretch(scale * (of[0] - of[1]), scale * (of[2] - of[3]));
    found.exponent[k] = std::log(stretch) / 2 / std::abs(to - from);
  }
  return found;
}

PictureGrid tracers_within(const PictureGrid& window, double spacing) {
  // As far as the last point, which rounding must not lose.
  const auto count = [&](int points) {
    return static_cast<int>((points - 1) * window.spacing / spacing + 1e-9) + 1;
  };
  return {window.first, spacing, count(window.columns), count(window.rows)};
}

}  // namespace vortree::flow
