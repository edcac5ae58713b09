#include "vortex/wall/along_wall.hpp"

#include <algorithm>
#include <cmath>

#include "vortex/cores/folded_core.hpp"
#include "vortex/wall/tuning.hpp"

namespace vortree::vortex {
namespace {

/// A quarter of the radius of curvature at each panel, `panels_smoothed` at most and one at least.
std::vector<double> allowed_by_bends(const Wall& wall) {
  std::vector<double> w(wall.panels());
  for (std::size_t i = 0; i < w.size(); ++i) {
    const double b = wall.panel_length(i);
    const double bend = std::abs(wall.shape().nearest(wall.middle(i)).curvature);
    w[i] = std::clamp(smoothed_of_radius / bend, b, panels_smoothed * b);
  }
  return w;
}

}  // namespace

Trace trace(const CoreAtWall& core) {
  const double kappa = core.at.curvature, s = core.across, y = core.at.distance / s;
  const double slant = core.along / s, bell = std::exp(-y * y);
  const double flat = 2 * folded::inverse_sqrt_pi / s * bell;
  const double bent = kappa / 2 * (std::erfc(y) + 2 * folded::inverse_sqrt_pi * y * bell);
  const double narrowed = 1 / std::sqrt(1 + kappa * core.at.distance * slant * slant);
  return {core.gamma * std::max(flat - bent, flat / 2), core.at.arc, core.along * narrowed};
}

namespace {

/// No more than what grows from each panel to the next, all around a body.
void bound_growth(std::span<double> w, double most) {
  const std::size_t n = w.size();
  for (std::size_t k = 1; k <= 2 * n; ++k) {  // twice around, either way
    w[k % n] = std::min(w[k % n], w[(k - 1) % n] + most);
    w[(2 * n - k) % n] = std::min(w[(2 * n - k) % n], w[(2 * n - k + 1) % n] + most);
  }
}

}  // namespace

AlongWall::AlongWall(const Wall& wall) : wall_(&wall), smoothed_over_(allowed_by_bends(wall)) {
  for (const Ring& ring : wall.rings())
    bound_growth(ring.of(smoothed_over_), steepest_smoothing * ring.length);
}

void AlongWall::add(const Trace& trace, std::span<double> all) const {
  const Ring& ring = wall_->rings()[wall_->ring_at(trace.arc)];
  const double b = ring.length, arc = trace.arc - ring.arc;
  const std::span<double> values = ring.of(all);
  const auto n = static_cast<std::ptrdiff_t>(values.size());
  const auto here = static_cast<std::ptrdiff_t>(std::floor(arc / b));
  const double w = smoothed_over_[ring.first + (here % n + n) % n],
               width = std::hypot(w, trace.width);
  const double share = (w / width) * (w / width),
               peak = trace.amount * folded::inverse_sqrt_pi / width;
  const auto within =
      static_cast<std::ptrdiff_t>(std::min(static_cast<double>(n), trace_support * width / b)) + 1;
  const std::ptrdiff_t first = here - std::min(within, (n - 1) / 2);
  const std::ptrdiff_t last = here + std::min(within, (n - 1) / 2);
  // The Gaussian of equidistant places: exp(-(x + h)^2) = exp(-x^2) exp(-2 x h - h^2), and that
  // ratio is multiplied by exp(-2 h^2) from one place to the next.
  const double h = b / width;
  double x = ((static_cast<double>(first) + 0.5) * b - arc) / width;
  double bell = peak * std::exp(-x * x), ratio = std::exp(-(2 * x + h) * h);
  const double turn = std::exp(-2 * h * h);
  std::ptrdiff_t i = (first % n + n) % n;
  for (std::ptrdiff_t k = first; k <= last; ++k) {
    values[i] += bell * (1 + share * (0.5 - x * x));
    bell *= ratio;
    ratio *= turn;
    x += h;
    if (++i == n) i = 0;
  }
}

}  // namespace vortree::vortex
