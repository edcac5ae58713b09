#include "vortex/folded_core.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace vortree::vortex::folded {
namespace {

constexpr int per_core = 64, nodes = per_core * static_cast<int>(reach) + 1, terms = 10;
using Series = std::array<double, terms>;

/// The mean's Taylor series about each node q: its second derivative is 2/sqrt(pi) exp(-q^2), whose
/// derivatives are that times a_n, a_(n+1) = -2 q a_n - 2 n a_(n-1).
std::array<Series, nodes> series_about_nodes() {
  std::array<Series, nodes> all;
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

const std::array<Series, nodes> about = series_about_nodes();

}  // namespace

Profile profile(double q) {
  const double size = std::abs(q);
  const int k = std::min(static_cast<int>(size * per_core + 0.5), nodes - 1);
  const double d = size - static_cast<double>(k) / per_core;
  const Series& c = about[k];
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

Gaussian place(double m, double s, double kappa) {
  if (!applies(m, s)) return {m, s};
  m = std::max(m, thinnest * s * inverse_sqrt_pi);
  const double bend = folded::bend(s, kappa);
  const double on_wall = s * (inverse_sqrt_pi - bend);  // mean distance of a centre on the wall
  if (m <= on_wall) {
    // m = s'/sqrt(pi) - kappa s'^2/8, the smaller root; past the sharpest edge m = s'/(2 sqrt(pi)).
    const double a = inverse_sqrt_pi;
    return {0, std::min(s, 2 * m / (a + std::sqrt(std::max(a * a - kappa * m / 2, 0.0))))};
  }
  // Near the wall m - on_wall = y^2/s (1/sqrt(pi) + 2 bend): a start from which Newton does not
  // overshoot.
  double y = std::sqrt((m - on_wall) * s / (inverse_sqrt_pi + 2 * bend));
  for (int k = 0; k < 12; ++k) {
    const double q = y / s;
    const Profile at = profile(q);
    const double mean = s * (at.mean - bend * ((1 - 2 * q * q) * (1 - at.erf) + q * at.slope));
    const double slope = at.erf + 4 * bend * q * (1 - at.erf);
    const double next = std::max(y - (mean - m) / slope, 0.0);
    // The error after a step is less than the square of the step over y.
    const bool settled = std::abs(next - y) <= 1e-8 * next;
    y = next;
    if (settled) break;
  }
  return {y, s};
}

namespace {

/// q = y/s of which (1/2 + q^2)/mu(q)^2 is `second`, E[n^2]/E[n]^2 of a core at a flat wall: pi/2
/// at q = 0, whence it falls as 1 - 2/3 q^4.
double depth(double second) {
  constexpr double at_wall = 0.5 / (inverse_sqrt_pi * inverse_sqrt_pi);
  const double quartic = std::sqrt(std::sqrt(1.5 * (1 - second / at_wall)));
  double q = quartic < 0.6 ? quartic : std::sqrt(0.5 / (second - 1));
  for (int k = 0; k < 20 && q < reach; ++k) {
    const Profile p = profile(q);
    const double ratio = (0.5 + q * q) / (p.mean * p.mean);
    const double slope = 2 * (q - ratio * p.mean * p.erf) / (p.mean * p.mean);
    const double next = std::max(q - (ratio - second) / slope, q / 2);
    if (std::abs(next - q) <= 1e-7 * q) return next;
    q = next;
  }
  return q;
}

}  // namespace

Gaussian place_with_variance(double m, double v_n, double kappa) {
  constexpr double widest = 0.5 / (inverse_sqrt_pi * inverse_sqrt_pi) - 1;
  m = std::max(m, thinnest * inverse_sqrt_pi * std::sqrt(2 * v_n));
  if (v_n >= (widest - 1e-9) * m * m) return place(m, 2 * m / inverse_sqrt_pi, kappa);
  const double q = depth(1 + v_n / (m * m));
  const double s = q < reach ? m / profile(q).mean : std::sqrt(2 * v_n);
  return place(m, s, kappa);
}

}  // namespace vortree::vortex::folded
