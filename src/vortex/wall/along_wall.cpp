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
void bound_growth(std::span<double> w, std::span<const double> b) {
  const std::size_t n = w.size();
  const auto most = [&](std::size_t i, std::size_t j) {
    return steepest_smoothing * ((b[i] + b[j]) / 2);
  };
  for (std::size_t k = 1; k <= 2 * n; ++k) {  // twice around, either way
    const std::size_t i = k % n, before = (k - 1) % n, j = (2 * n - k) % n, after = (j + 1) % n;
    w[i] = std::min(w[i], w[before] + most(before, i));
    w[j] = std::min(w[j], w[after] + most(j, after));
  }
}

}  // namespace

AlongWall::AlongWall(const Wall& wall) : wall_(&wall), smoothed_over_(allowed_by_bends(wall)) {
  const std::span<const double> lengths = wall.panel_lengths();
  for (const Ring& ring : wall.rings()) bound_growth(ring.of(smoothed_over_), ring.of(lengths));
}

/// A trace and what smooths it.
struct AlongWall::Smoothed {
  double arc, width, peak, share;

  Smoothed(const Trace& trace, double w)
      : arc(trace.arc),
        width(std::hypot(w, trace.width)),
        peak(trace.amount * folded::inverse_sqrt_pi / width),
        share((w / width) * (w / width)) {}
  /// What multiplies the Gaussian at so many widths from the middle.
  double sharp(double x) const { return 1 + share * (0.5 - x * x); }
};

void AlongWall::add(const Trace& trace, std::span<double> all) const {
  const std::size_t body = wall_->ring_at(trace.arc);
  const Ring& ring = wall_->rings()[body];
  if (ring.even)
    add_evenly(trace, ring, ring.of(all));
  else
    add_unevenly(trace, wall_->panel_at(body, trace.arc), ring, ring.of(all));
}

void AlongWall::add_evenly(const Trace& trace, const Ring& ring, std::span<double> values) const {
  const double b = ring.length, arc = trace.arc - ring.arc;
  const auto n = static_cast<std::ptrdiff_t>(values.size());
  const auto here = static_cast<std::ptrdiff_t>(std::floor(arc / b));
  const Smoothed smoothed(trace, smoothed_over_[ring.first + (here % n + n) % n]);
  const double width = smoothed.width;
  const auto within =
      static_cast<std::ptrdiff_t>(std::min(static_cast<double>(n), trace_support * width / b)) + 1;
  const std::ptrdiff_t first = here - std::min(within, (n - 1) / 2);
  const std::ptrdiff_t last = here + std::min(within, (n - 1) / 2);
  // The Gaussian of equidistant places: exp(-(x + h)^2) = exp(-x^2) exp(-2 x h - h^2), and that
  // ratio is multiplied by exp(-2 h^2) from one place to the next.
  const double h = b / width;
  double x = ((static_cast<double>(first) + 0.5) * b - arc) / width;
  double bell = smoothed.peak * std::exp(-x * x), ratio = std::exp(-(2 * x + h) * h);
  const double turn = std::exp(-2 * h * h);
  std::ptrdiff_t i = (first % n + n) % n;
  for (std::ptrdiff_t k = first; k <= last; ++k) {
    values[i] += bell * smoothed.sharp(x);
    bell *= ratio;
    ratio *= turn;
    x += h;
    if (++i == n) i = 0;
  }
}

void AlongWall::add_unevenly(const Trace& trace, std::size_t here, const Ring& ring,
                             std::span<double> values) const {
  const Smoothed smoothed(trace, smoothed_over_[here]);
  const double around = ring.length * static_cast<double>(ring.panels);
  const auto put = [&](std::size_t i) {
    const double way = wall_->arc(ring.first + i) - smoothed.arc;
    const double x = (way - around * std::nearbyint(way / around)) / smoothed.width;
    values[i] += smoothed.peak * std::exp(-x * x) * smoothed.sharp(x);
    return std::abs(x) < trace_support;
  };
  const std::size_t n = ring.panels, middle = here - ring.first;
  put(middle);
  for (std::size_t k = 1; k <= (n - 1) / 2 && put((middle + k) % n); ++k) continue;
  for (std::size_t k = 1; k <= (n - 1) / 2 && put((middle + n - k) % n); ++k) continue;
}

}  // namespace vortree::vortex
