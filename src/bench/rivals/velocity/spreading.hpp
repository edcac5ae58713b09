#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "bench/rivals/velocity/window.hpp"
#include "tree/base/memory.hpp"
#include "tree/order/points.hpp"

namespace vortree::bench {

/// The grid that points are spread onto: line m lies at origin + m spacing, counted from 0. All
/// windows of the points fit in.
struct SpreadingLattice {
  double x0, y0, spacing;
  int nx, ny;
  [[nodiscard]] std::size_t stride() const { return (nx + Window::lanes + 7u) / 8 * 8; }
  [[nodiscard]] std::size_t values() const { return stride() * ny + 2 * Window::most_width; }
};

/// Points in the order in which they visit a lattice: by strips of rows, in a strip by columns.
struct Visitors {
  Reals x, y;                        // in grid spacings
  std::vector<std::uint32_t> index;  // visitor j is point index[j]
  std::vector<std::size_t> strips;   // visitors strips[s] .. strips[s + 1] - 1 are of strip s
};
Visitors visitors(const tree::Points& points, const SpreadingLattice& lattice, int width);

/// grid[m] = sum_j gamma_j phi(m - x_j) phi(n - y_j)
/// gamma     in the order of the points
/// cost      width^2 products a point; threads share the strips, same bits for any number
void spread(const Visitors& from, std::span<const double> gamma, const Window& window,
            const SpreadingLattice& lattice, std::span<double> grid);

/// u_i = sum_m grid_u[m] phi(m - x_i) phi(n - y_i), v alike, in the order of the points.
void gather(const Visitors& at, const Window& window, const SpreadingLattice& lattice,
            std::span<const double> grid_u, std::span<const double> grid_v, std::span<double> u,
            std::span<double> v);

}  // namespace vortree::bench
