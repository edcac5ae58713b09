#include "vortex/cores/folded_core.hpp"

#include <algorithm>
#include <array>
#include <numbers>
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

/// The width s of a core whose centre is q widths from the wall and whose mean is m - k s^2/4 from
/// it: (mean - bend(s) taken) s + k s^2/4 = m, the smaller root.
///
/// mean, taken  of a core of width 1 at q from a flat wall, and what a bent one takes of it
double width(double m, double mean, double taken, double kappa, double k) {
  const double square = (k - kappa * taken / 2) / 4;
  const double s = 2 * m / (mean + std::sqrt(std::max(mean * mean + 4 * square * m, 0.0)));
  if (kappa * s / 8 <= sharpest) return s;
  mean -= sharpest * taken;
  return 2 * m / (mean + std::sqrt(std::max(mean * mean + k * m, 0.0)));
}

/// The same of one centred on the wall.
double width_on_wall(double m, double kappa, double k) {
  return width(m, inverse_sqrt_pi, 1, kappa, k);
}

}  // namespace

Gaussian place(double m, double s, double kappa, double k) {
  const double mean = m - k * s * s / 4;
  if (!applies(mean, s)) return {mean, s};
  m = std::max(m, thinnest * s * inverse_sqrt_pi);
  const double bend = folded::bend(s, kappa);
  const double least = s * (inverse_sqrt_pi - bend);  // of a centre on the wall
  if (mean <= least) return {0, std::min(s, width_on_wall(m, kappa, k))};
  // Near the wall mean - least = y^2/s (1/sqrt(pi) + 2 bend): a start from which Newton does not
  // overshoot.
  double y = std::sqrt((mean - least) * s / (inverse_sqrt_pi + 2 * bend));
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

/// q = y/s at a flat wall of which v_n/m^2 is `part`, to 0.03 of a core: q^4 as a polynomial of
/// sqrt(0.5/part), which is 0.936 on the wall and q far from it. Nothing on the wall and below.
double flat_depth(double part) {
  const double y = std::sqrt(0.5 / part) - std::sqrt(1 / (std::numbers::pi - 2));
  return y > 0 ? std::sqrt(std::sqrt(y * (1.33 + y * (11.76 + y * (2.17 * y - 1.43))))) : 0;
}

/// The same at a bent wall, whose core would have the width s with its centre on the wall: there
/// v_n/m^2 is largest, at a flat one whence 1 + v_n/m^2 falls as 1 - 2/3 q^4, at a convex one with
/// a term in q^2 besides. (One that the core follows may have it largest at some q: the farther of
/// two places is meant.)
double likely_depth(double part, double s, double kappa, double k) {
  const double b = bend(s, kappa);
  const Bent edge(on_wall, 0, b);
  const double rise = inverse_sqrt_pi + 2 * b, mean = edge.mean + k * s / 4;
  const double across_rise = 1 + 4 * inverse_sqrt_pi * b - 2 * edge.mean * rise;
  // By how much more the width falls as the bend and the part along it do.
  const double narrower = edge.across * (k * s / 2 - 2 * b) / edge.mean + edge.across_taken * b;
  const double most = 1 + edge.across / (mean * mean);
  const double square =
      (2 * edge.across * rise / mean - across_rise - narrower) / (mean * mean * most);
  const double fallen = std::max(1 - (1 + part) / most, 0.0);
  const double near = 0.75 * (std::sqrt(square * square + 8.0 / 3 * fallen) - square);
  return near < 0.12 ? std::max(std::sqrt(near), 1e-5) : std::max(flat_depth(part), 0.3);
}

/// The core whose mean distance is m - k s^2/4 and whose variance is v_n, at a wall that is not
/// concave: Newton's steps in q = y/s of the inverse root of the variance, which grows evenly with
/// q, for cores whose s has them at that mean. `settled`: found, and nearer than `support`.
///
/// q  where to begin
struct AtDepth {
  Gaussian core;
  bool settled;
};
AtDepth at_depth(double q, double m, double v_n, double kappa, double k) {
  double s = 0;
  for (int step = 0; step < 20; ++step) {
    const Profile flat = profile(q);
    const double taken = Bent(flat, q, 0).taken;
    s = width(m, flat.mean, taken, kappa, k);
    const double b = bend(s, kappa), bent_more = b < sharpest ? kappa / 8 : 0;
    const Bent at(flat, q, b);
    const double wider = -s * at.slope / (at.mean + s * (k / 2 - bent_more * taken));
    const double variance = s * s * at.across;
    const double change =
        s * s * (at.across_slope - at.across_taken * bent_more * wider) + 2 * s * wider * at.across;
    const double by = 2 * variance * (1 - std::sqrt(variance / v_n)) / change;
    const double next = std::max(q + by, q / 2);
    if (std::abs(next - q) <= 1e-6 * q) return {{next * (s + wider * by), s + wider * by}, true};
    q = next;
    if (q >= support) break;
  }
  return {{q * s, q < support ? s : std::sqrt(2 * v_n)}, false};
}

}  // namespace

Gaussian place_with_variance(double m, double v_n, double kappa, double k) {
  m = std::max(m, thinnest * inverse_sqrt_pi * std::sqrt(2 * v_n));
  const double convex = std::max(kappa, 0.0), widest = width_on_wall(m, convex, k);
  if (v_n >= widest * widest * Bent(on_wall, 0, bend(widest, convex)).across - 1e-9 * m * m)
    return place(m, widest, kappa, k);
  const double likely = likely_depth(v_n / (m * m), widest, convex, k);
  const auto [core, settled] = at_depth(likely, m, v_n, convex, k);
  return settled && kappa >= 0 ? core : place(m, core.s, kappa, k);
}

}  // namespace vortree::vortex::folded
