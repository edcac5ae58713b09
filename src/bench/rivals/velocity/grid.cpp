#include "bench/rivals/velocity/grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>

#include "bench/rivals/velocity/convolution.hpp"
#include "bench/rivals/velocity/spreading.hpp"
#include "bench/rivals/velocity/window.hpp"
#include "fmm/geometry/units.hpp"

namespace vortree::bench {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double least_tolerance = 1e-15;  // nothing is gained by asking for less

std::string written(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

// The one core size of the blobs.
double common_core(std::span<const double> sigma) {
  if (sigma.empty()) return 0.0;
  const auto [least, most] = std::ranges::minmax(sigma);
  if (least == 0.0) throw std::invalid_argument("the grid cannot sum bare vortices, only blobs");
  if (most > least * (1.0 + 1e-12))
    throw std::invalid_argument("the grid wants blobs of one core size; these have sigma from " +
                                written(least) + " to " + written(most));
  return least;
}

struct GridBox {
  double x0, x1, y0, y1;
  [[nodiscard]] double width() const { return x1 - x0; }
  [[nodiscard]] double height() const { return y1 - y0; }
};

GridBox around(const fmm::Sources& blobs, const fmm::Targets& targets) {
  GridBox box{INFINITY, -INFINITY, INFINITY, -INFINITY};
  const auto take = [&](std::span<const double> x, std::span<const double> y) {
    for (const double value : x) box.x0 = std::min(box.x0, value), box.x1 = std::max(box.x1, value);
    for (const double value : y) box.y0 = std::min(box.y0, value), box.y1 = std::max(box.y1, value);
  };
  take(blobs.x, blobs.y);
  if (targets.x.data() != blobs.x.data()) take(targets.x, targets.y);
  return box;
}

/// How fine the grid is and how wide the window.
///
/// The spectrum of a core, exp(-sigma^2 k^2/4), falls to the tolerance at k = 2 sqrt(E)/sigma with
/// E = ln(1/tolerance): the spacing pi/k would just resolve it. A grid `finer` times that lets
///   width = E / (pi (1 - 1/(2 finer))),  shape = E
/// do: window and core together damp the copies of every frequency by the tolerance, even without
/// any spare grid (finer = 1), since sqrt(shape^2 - (k width/2)^2) + sigma^2 k^2/4 is concave in
/// k^2 and large enough at both ends.
struct Resolution {
  double spacing, shape, accuracy;
  int width;
};

// Damping asked of the window beyond the tolerance, measured (tests/bench/rivals/grid.cpp).
constexpr double window_margin = 10.0;

Resolution resolution(double sigma, double tolerance, double finer) {
  const double decay = std::log(1.0 / tolerance);
  const double window_decay = std::log(window_margin / tolerance);
  const double share = pi * (1.0 - 0.5 / finer);
  const int width = std::max(2, static_cast<int>(std::ceil(window_decay / share)));
  return {.spacing = 0.5 * pi * sigma / (std::sqrt(decay) * finer),
          .shape = width * share,
          .accuracy = 0.01 * tolerance,
          .width = width};
}

struct GridLayout {
  Resolution resolution;
  SpreadingLattice lattice;
  Convolution::Size size;
  double reach;  // in spacings

  [[nodiscard]] double bytes() const {
    return 16.0 * size.ny * (size.px + 2.0) + 16.0 * static_cast<double>(lattice.values());
  }
};

double lines(double length, const Resolution& of) {
  return std::floor(length / of.spacing) + of.width + 2;
}

// Copies must not be felt: every point is `reach` or more away from them, cores included.
double period(double length, double reach, const Resolution& of) {
  return std::max(lines(length, of), std::ceil(length / of.spacing + reach));
}

GridLayout lay_out(const GridBox& box, double sigma, double tolerance, const Resolution& of,
                   double most_bytes) {
  const double tail = sigma * std::sqrt(std::log(1.0 / tolerance));
  const double reach = (std::hypot(box.width(), box.height()) + tail) / of.spacing;
  const double felt = reach + tail / of.spacing;
  const double nx = lines(box.width(), of), ny = lines(box.height(), of);
  const double px = period(box.width(), felt, of), py = period(box.height(), felt, of);
  if (16.0 * ny * (px + nx) > most_bytes || px > 1e8 || py > 1e8)
    throw std::invalid_argument("the grid would need " + written(px) + " x " + written(py) +
                                " lines to resolve cores of " + written(sigma) +
                                "; it is for cores that fill their space");
  GridLayout layout{.resolution = of, .lattice = {}, .size = {}, .reach = reach};
  layout.size = {static_cast<int>(nx), static_cast<int>(ny), smooth_length(static_cast<int>(px)),
                 smooth_length(static_cast<int>(py))};
  const double margin = (0.5 * of.width + 0.5) * of.spacing;
  layout.lattice = {box.x0 - margin, box.y0 - margin, of.spacing, layout.size.nx, layout.size.ny};
  return layout;
}

// Nanoseconds, about: of the windows of a blob and of a target, and of the transforms.
double cost(const GridLayout& layout, double points) {
  const double width = layout.resolution.width;
  const double windows = width <= Window::lanes ? 20.0 + 2.0 * width : 10.0 * width - 20.0;
  return 0.5 * points * windows + 7.0 * layout.size.px * static_cast<double>(layout.size.py);
}

GridLayout best_layout(const GridBox& box, double sigma, double points,
                       const GridOptions& options) {
  const double tolerance = std::max(options.tolerance, least_tolerance);
  const auto most = static_cast<double>(options.most_bytes);
  std::optional<GridLayout> best;
  for (const double finer : {1.0, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.8, 2.0, 2.5, 3.0}) {
    const Resolution of = resolution(sigma, tolerance, finer);
    if (of.width > Window::most_width) continue;
    if (best && best->bytes() * finer * finer > most) break;
    const GridLayout other = lay_out(box, sigma, tolerance, of, most);
    if (!best || cost(other, points) < cost(*best, points)) best = other;
  }
  return *best;
}

// exp(-sigma^2 k^2/4) / transform(k)^2: the core put in, spreading and gathering taken out.
std::vector<double> factors(int period, double sigma, const Window& window) {
  std::vector<double> made(period / 2 + 1);
  for (int q = 0; q <= period / 2; ++q) {
    const double xi = 2.0 * pi * q / period, transform = window.transform(xi);
    made[q] = std::exp(-0.25 * sigma * sigma * xi * xi) / (transform * transform);
  }
  return made;
}

void check(const fmm::Sources& blobs, const fmm::Targets& targets, const GridOptions& options,
           std::span<const double> u, std::span<const double> v) {
  fmm::check(blobs);
  fmm::check(targets);
  fmm::check_result(targets.size(), u, v);
  if (!(options.tolerance > 0.0 && options.tolerance < 1.0))
    throw std::invalid_argument("tolerance is " + written(options.tolerance) +
                                "; it must be in (0, 1)");
}

bool same(const fmm::Sources& blobs, const fmm::Targets& targets) {
  return targets.x.data() == blobs.x.data() && targets.y.data() == blobs.y.data() &&
         targets.size() == blobs.size();
}

}  // namespace

GridWork velocity_grid(const fmm::Sources& blobs, const fmm::Targets& targets,
                       const GridOptions& options, std::span<double> u, std::span<double> v,
                       const tree::Phase& phase) {
  const auto begin = [&phase](std::string_view name) {
    if (phase) phase(name);
  };
  begin("plan");
  check(blobs, targets, options, u, v);
  if (blobs.size() == 0 || targets.size() == 0) {
    std::ranges::fill(u, 0.0);
    std::ranges::fill(v, 0.0);
    return {};
  }
  const double sigma = common_core(blobs.sigma);
  if (sigma == 0.0) throw std::invalid_argument("the grid cannot sum bare vortices, only blobs");
  const auto points = static_cast<double>(blobs.size() + targets.size());
  const GridLayout layout = best_layout(around(blobs, targets), sigma, points, options);
  const Resolution& of = layout.resolution;
  const Window window(of.width, of.shape, of.accuracy);
  const double core = sigma / of.spacing;
  const VortexSpectrum vortex(layout.reach, 4.5);  // to pi along both directions
  Convolution convolution(layout.size, options.measured);
  const Convolution::Factors both{factors(layout.size.px, core, window),
                                  factors(layout.size.py, core, window)};

  begin("spread");
  Reals grid(layout.lattice.values()), grid_v(layout.lattice.values());
  const Visitors from = visitors({blobs.x, blobs.y}, layout.lattice, of.width);
  spread(from, blobs.gamma, window, layout.lattice, grid);

  begin("transform");
  std::ranges::fill(grid_v, 0.0);
  convolution.velocity(vortex, both, layout.lattice.stride(), grid, grid, grid_v);
  for (double& value : grid) value /= of.spacing;
  for (double& value : grid_v) value /= of.spacing;

  begin("gather");
  if (same(blobs, targets)) {
    gather(from, window, layout.lattice, grid, grid_v, u, v);
  } else {
    const Visitors at = visitors({targets.x, targets.y}, layout.lattice, of.width);
    gather(at, window, layout.lattice, grid, grid_v, u, v);
  }
  return {layout.size.nx, layout.size.ny, layout.size.px, layout.size.py, of.width, of.spacing};
}

}  // namespace vortree::bench
