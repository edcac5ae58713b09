#include "vortex/wall/along_wall.hpp"

#include <algorithm>
#include <cmath>

#include "vortex/cores/folded_core.hpp"
#include "vortex/wall/tuning.hpp"

namespace vortree::vortex {
namespace {

/// A quarter of the radius of curvature at each panel, `panels_smoothed` at most and one at least.
std::vector<double> allowed_by_bends(const Wall& wall) {
  const double b = wall.panel_length();
  std::vector<double> w(wall.panels());
  for (std::size_t i = 0; i < w.size(); ++i) {
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

AlongWall::AlongWall(const Wall& wall)
    : panel_length_(wall.panel_length()), smoothed_over_(allowed_by_bends(wall)) {
  std::vector<double>& w = smoothed_over_;
  const std::size_t n = w.size();
  for (std::size_t k = 1; k <= 2 * n; ++k) {  // twice around, either way
    w[k % n] = std::min(w[k % n], w[(k - 1) % n] + steepest_smoothing * panel_length_);
    w[(2 * n - k) % n] =
        std::min(w[(2 * n - k) % n], w[(2 * n - k + 1) % n] + steepest_smoothing * panel_length_);
  }
}

void AlongWall::add(const Trace& trace, std::span<double> values) const {
  const auto n = static_cast<std::ptrdiff_t>(values.size());
  const auto here = static_cast<std::ptrdiff_t>(std::floor(trace.arc / panel_length_));
  const double w = smoothed_over_[(here % n + n) % n], width = std::hypot(w, trace.width);
  const double share = (w / width) * (w / width),
               peak = trace.amount * folded::inverse_sqrt_pi / width;
  const auto within = static_cast<std::ptrdiff_t>(
                          std::min(static_cast<double>(n), trace_support * width / panel_length_)) +
                      1;
  const std::ptrdiff_t first = here - std::min(within, (n - 1) / 2);
  const std::ptrdiff_t last = here + std::min(within, (n - 1) / 2);
  // The Gaussian of equidistant places: exp(-(x + h)^2) = exp(-x^2) exp(-2 x h - h^2), and that
  // ratio is multiplied by exp(-2 h^2) from one place to the next.
  const double h = panel_length_ / width;
  double x = ((static_cast<double>(first) + 0.5) * panel_length_ - trace.arc) / width;
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
