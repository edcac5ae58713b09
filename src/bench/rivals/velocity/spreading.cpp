#include "bench/rivals/velocity/spreading.hpp"

#include <algorithm>
#include <cmath>

#include "tree/order/radix_sort.hpp"

namespace vortree::bench {
namespace {

// Two neighbouring strips overlap by a window, so that every other strip may be spread at once.
constexpr int strip_rows = 32;
static_assert(strip_rows >= Window::most_width);

// First grid line of a window about x, and its weights.
template <int vectors>
struct Weights {
  int first_x, first_y;
  Lanes x[vectors], y[vectors];

  Weights(const Window& window, double at_x, double at_y) {
    const double left = at_x - 0.5 * window.width(), below = at_y - 0.5 * window.width();
    first_x = static_cast<int>(std::ceil(left));
    first_y = static_cast<int>(std::ceil(below));
    window.weigh<vectors>(first_x - left, x);
    window.weigh<vectors>(first_y - below, y);
  }
  [[nodiscard]] std::size_t first(std::size_t stride) const { return first_y * stride + first_x; }
  [[nodiscard]] const double* rows() const { return reinterpret_cast<const double*>(y); }
};

template <int vectors>
void spread_one(const Weights<vectors>& weights, double gamma, int width, std::size_t stride,
                double* grid) {
  double* row = grid + weights.first(stride);
  const double* weight = weights.rows();
  for (int r = 0; r < width; ++r, row += stride) {
    const double strength = gamma * weight[r];
#pragma GCC unroll 4
    for (int c = 0; c < vectors; ++c) {
      double* place = row + c * Window::lanes;
      store(place, load(place) + strength * weights.x[c]);
    }
  }
}

template <int vectors>
void spread_strips(const Visitors& from, std::span<const double> gamma, const Window& window,
                   std::size_t stride, double* grid) {
  const int strips = static_cast<int>(from.strips.size()) - 1;
  for (const int parity : {0, 1}) {
#pragma omp parallel for schedule(dynamic)
    for (int s = parity; s < strips; s += 2) {
      for (std::size_t j = from.strips[s]; j < from.strips[s + 1]; ++j) {
        const Weights<vectors> weights(window, from.x[j], from.y[j]);
        spread_one(weights, gamma[from.index[j]], window.width(), stride, grid);
      }
    }
  }
}

/// `run<vectors>()` for a number of vectors that is known only now.
template <int most = Window::most_width / Window::lanes>
void with_vectors(int vectors, const auto& run) {
  if constexpr (most > 1) {
    if (vectors < most) return with_vectors<most - 1>(vectors, run);
  }
  run.template operator()<most>();
}

struct Velocity {
  double u, v;
};

template <int vectors>
Velocity gather_one(const Weights<vectors>& weights, int width, std::size_t stride,
                    const double* grid_u, const double* grid_v) {
  Lanes u[vectors] = {}, v[vectors] = {};
  std::size_t place = weights.first(stride);
  const double* weight = weights.rows();
  for (int r = 0; r < width; ++r, place += stride) {
#pragma GCC unroll 4
    for (int c = 0; c < vectors; ++c) {
      u[c] += weight[r] * load(grid_u + place + c * Window::lanes);
      v[c] += weight[r] * load(grid_v + place + c * Window::lanes);
    }
  }
  Lanes sum_u = {}, sum_v = {};
#pragma GCC unroll 4
  for (int c = 0; c < vectors; ++c) {
    sum_u += u[c] * weights.x[c];
    sum_v += v[c] * weights.x[c];
  }
  return {sum(sum_u), sum(sum_v)};
}

template <int vectors>
void gather_all(const Visitors& at, const Window& window, std::size_t stride, const double* grid_u,
                const double* grid_v, std::span<double> u, std::span<double> v) {
  const std::size_t n = at.index.size();
#pragma omp parallel for schedule(dynamic, 1024)
  for (std::size_t j = 0; j < n; ++j) {
    const Weights<vectors> weights(window, at.x[j], at.y[j]);
    const Velocity sum = gather_one(weights, window.width(), stride, grid_u, grid_v);
    u[at.index[j]] = sum.u;
    v[at.index[j]] = sum.v;
  }
}

}  // namespace

Visitors visitors(const tree::Points& points, const SpreadingLattice& lattice, int width) {
  const std::size_t n = points.x.size();
  const double inverse = 1.0 / lattice.spacing;
  const auto place = [&](double value, double origin) { return (value - origin) * inverse; };
  Visitors made;
  std::vector<tree::MortonKey> keys(n);
  made.index.resize(n);
  made.x.resize(n);
  made.y.resize(n);
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < n; ++i) {
    const double x = place(points.x[i], lattice.x0), y = place(points.y[i], lattice.y0);
    const auto first_y = static_cast<tree::MortonKey>(std::ceil(y - 0.5 * width));
    keys[i] = first_y / strip_rows * lattice.nx + static_cast<tree::MortonKey>(x);
    made.index[i] = static_cast<std::uint32_t>(i);
  }
  tree::radix_sort(keys, made.index);
#pragma omp parallel for schedule(static)
  for (std::size_t j = 0; j < n; ++j) {
    made.x[j] = place(points.x[made.index[j]], lattice.x0);
    made.y[j] = place(points.y[made.index[j]], lattice.y0);
  }
  for (tree::MortonKey s = 0; s <= static_cast<tree::MortonKey>(lattice.ny / strip_rows) + 1; ++s)
    made.strips.push_back(std::ranges::lower_bound(keys, s * lattice.nx) - keys.begin());
  return made;
}

void spread(const Visitors& from, std::span<const double> gamma, const Window& window,
            const SpreadingLattice& lattice, std::span<double> grid) {
#pragma omp parallel for schedule(static)
  for (std::size_t m = 0; m < grid.size(); ++m) grid[m] = 0.0;
  const auto run = [&]<int vectors>() {
    spread_strips<vectors>(from, gamma, window, lattice.stride(), grid.data());
  };
  with_vectors(window.vectors(), run);
}

void gather(const Visitors& at, const Window& window, const SpreadingLattice& lattice,
            std::span<const double> grid_u, std::span<const double> grid_v, std::span<double> u,
            std::span<double> v) {
  const auto run = [&]<int vectors>() {
    gather_all<vectors>(at, window, lattice.stride(), grid_u.data(), grid_v.data(), u, v);
  };
  with_vectors(window.vectors(), run);
}

}  // namespace vortree::bench
