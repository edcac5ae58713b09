#include "vortex/cores/folded_core.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace vortree::vortex::folded {
namespace {

constexpr int per_core = 64, nodes = per_core * static_cast<int>(support) + 1, terms = 10;
constexpr double past_nodes = (nodes - 0.5) / per_core;
using Taylor = std::array<double, terms>;

/// The mean's Taylor series about each node q: its second derivative is 2/sqrt(pi) exp(-q^2), whose
/// derivatives are that times a_n, a_(n+1) = -2 q a_n - 2 n a_(n-1).
std::array<Taylor, nodes> series_about_nodes() {
  std::array<Taylor, nodes> all;
  for (int k = 0; k < nodes; ++k) {
    const double q = static_cast<double>(k) / per_core, bell = std::exp(-q * q);
    all[k][0] = inverse_sqrt_pi * bell + q * std::erf(q);
    all[k][1] = std::erf(q);
    double factorial = 2, before = 0, now = 1;
    for (int n = 0; n + 2 < terms; ++n) {
      all[k][n + 2] = 2 * inverse_sqrt_pi * bell * now / factorial;
      factorial *= n + 3;
      before = std::exchange(now, -2 * q * now - 2 * n * before);
    }
  }
  return all;
}

const std::array<Taylor, nodes> about = series_about_nodes();

}  // namespace

Profile profile(double q) {
  const double size = std::abs(q);
  if (!(size < past_nodes)) return {size, std::copysign(1.0, q), 0};
  const int k = static_cast<int>(size * per_core + 0.5);
  const double d = size - static_cast<double>(k) / per_core;
  const Taylor& c = about[k];
  Profile at{c[terms - 1], 0, 0};
  double half_slope = 0;
  for (int n = terms - 2; n >= 0; --n) {
    half_slope = half_slope * d + at.erf;
    at.erf = at.erf * d + at.mean;
    at.mean = at.mean * d + c[n];
  }
  at.slope = 2 * half_slope;
  at.erf = std::copysign(at.erf, q);
  return at;
}

namespace {

/// The width of a core centred on the wall: (1/sqrt(pi) - bend) s + k s^2/4 = m, the smaller root.
double width_on_wall(double m, double kappa, double k) {
  const double a = inverse_sqrt_pi, square = k / 4 - kappa / 8;
  const double s = 2 * m / (a + std::sqrt(std::max(a * a + 4 * square * m, 0.0)));
  if (kappa * s / 8 <= a / 2) return s;
  return 2 * m / (a / 2 + std::sqrt(std::max(a * a / 4 + k * m, 0.0)));  // past the sharpest edge
}

}  // namespace

Gaussian place(double m, double s, double kappa, double k) {
  const double mean = m - k * s * s / 4;
  if (!applies(mean, s)) return {mean, s};
  m = std::max(m, thinnest * s * inverse_sqrt_pi);
  const double bend = folded::bend(s, kappa);
  const double on_wall = s * (inverse_sqrt_pi - bend);  // mean distance of a centre on the wall
  if (mean <= on_wall) return {0, std::min(s, width_on_wall(m, kappa, k))};
  // Near the wall mean - on_wall = y^2/s (1/sqrt(pi) + 2 bend): a start from which Newton does not
  // overshoot.
  double y = std::sqrt((mean - on_wall) * s / (inverse_sqrt_pi + 2 * bend));
  for (int step = 0; step < 12; ++step) {
    const Bent at(y / s, bend);
    const double next = std::max(y - (s * at.mean - mean) / at.slope, 0.0);
    // The error after a step is less than the square of the step over y.
    const bool settled = next == 0 || std::abs(next - y) <= 1e-8 * next;
    y = next;
    if (settled) break;
  }
  return {y, s};
}

namespace {

/// q = y/s of which v_n/m^2 is `part`, of the core whose mean distance is m - k s^2/4: largest on
/// the wall, at a flat one whence 1 + v_n/m^2 falls as 1 - 2/3 q^4, at a convex one with a term in
/// q^2 besides.
///
/// on_wall  the core's width if its centre were on the wall
double depth(double part, double m, double on_wall, double kappa, double k) {
  double s = on_wall, b = bend(s, kappa);
  const Bent edge(0, b);
  const double rise = inverse_sqrt_pi + 2 * b, mean = edge.mean + k * s / 4;
  const double across_rise = 1 + 4 * inverse_sqrt_pi * std::max(b, 0.0) - 2 * edge.mean * rise;
  const double most = 1 + edge.across / (mean * mean);
  const double square =
      std::max((2 * edge.across * rise / mean - across_rise) / (mean * mean * most), 0.0);
  const double fallen = std::max(1 - (1 + part) / most, 0.0);
  const double start = 0.75 * (std::sqrt(square * square + 8.0 / 3 * fallen) - square);
  double q = std::max(std::sqrt(start), 1e-5);
  if (q > 0.6) q = std::sqrt(0.5 / part);
  for (int step = 0; step < 20 && q < support; ++step) {
    s = m / (Bent(q, b).mean + k * s / 4);
    b = bend(s, kappa);
    const Bent at(q, b);
    const double now = at.mean + k * s / 4, ratio = at.across / (now * now);
    const double slope = (at.across_slope - 2 * ratio * now * at.slope) / (now * now);
    const double next = std::max(q - (ratio - part) / slope, q / 2);
    if (std::abs(next - q) <= 1e-7 * q) return next;
    q = next;
  }
  return q;
}

}  // namespace

Gaussian place_with_variance(double m, double v_n, double kappa, double k) {
  m = std::max(m, thinnest * inverse_sqrt_pi * std::sqrt(2 * v_n));
  const double convex = std::max(kappa, 0.0), on_wall = width_on_wall(m, convex, k);
  if (v_n >= on_wall * on_wall * Bent(0, bend(on_wall, convex)).across - 1e-9 * m * m)
    return place(m, on_wall, kappa, k);
  const double q = depth(v_n / (m * m), m, on_wall, convex, k);
  double s = std::sqrt(2 * v_n);
  for (int step = 0; q < support && step < 3; ++step)
    s = std::sqrt(v_n / Bent(q, bend(s, convex)).across);
  return place(m, s, kappa, k);
}

}  // namespace vortree::vortex::folded
