#include "vortex/blobs/lattice.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "tree/base/told.hpp"

namespace vortree::vortex {
namespace {

/// Blobs with the weight of their place (from the centre), out to `reach`, gamma in all.
template <class Weight>
Blobs cut(const Lattice& lattice, double gamma, Vec2 reach, Weight weight) {
  const double h = lattice.h;
  const int columns = static_cast<int>(reach.x / h) + 1, rows = static_cast<int>(reach.y / h) + 1;
  Blobs blobs;
  double total = 0;
  for (int j = -rows; j <= rows; ++j)
    for (int i = -columns; i <= columns; ++i) {
      const Vec2 at{i * h, j * h};
      const double w = weight(at);
      if (std::abs(w) < lattice.faintest) continue;
      blobs.append(lattice.centre + at, w, lattice.sigma_0);
      total += w;
    }
  for (double& g : blobs.gamma) g *= gamma / total;
  return blobs;
}

void require(bool holds, const Lattice& lattice, double a, double b, const char* expected) {
  if (holds && lattice.sigma_0 > 0 && lattice.h > 0) return;
  throw std::invalid_argument("a vortex of widths " + tree::told(a) + ", " + tree::told(b) +
                              " cut into cores of " + tree::told(lattice.sigma_0) + " every " +
                              tree::told(lattice.h) + "; " + expected +
                              " > 0 and spacing > 0 were expected");
}

}  // namespace

Blobs gaussian_ellipse(const Lattice& lattice, double gamma, double a, double b) {
  const double s = lattice.sigma_0;
  require(a > s && b > s, lattice, a, b, "widths > sigma_0");
  const double p2 = a * a - s * s, q2 = b * b - s * s, far = -std::log(lattice.faintest);
  return cut(lattice, gamma, {std::sqrt(p2 * far), std::sqrt(q2 * far)},
             [&](Vec2 at) { return std::exp(-at.x * at.x / p2 - at.y * at.y / q2); });
}

Blobs gaussian_vortex(Vec2 centre, double gamma, double core, double sigma_0, double h) {
  return gaussian_ellipse({centre, sigma_0, h}, gamma, core, core);
}

Blobs perturbed_vortex(const Lattice& lattice, double gamma, double a, double p) {
  const double s = lattice.sigma_0;
  require(a > s, lattice, a, a, "widths > sigma_0");
  const double s2 = a * a - s * s, bump = p * a * a / (s2 * s2);
  // The bump is largest near 2 s; 3 s more cover what it lifts above the faintest.
  const double reach = std::sqrt(-s2 * std::log(lattice.faintest)) + 3 * std::sqrt(s2);
  return cut(lattice, gamma, {reach, reach}, [&](Vec2 at) {
    return std::exp(-dot(at, at) / s2) * (1 + bump * (at.x * at.x - at.y * at.y));
  });
}

Blobs uniform_ellipse(const Lattice& lattice, double gamma, double a, double b) {
  require(a > 0 && b > 0, lattice, a, b, "widths and sigma_0");
  constexpr int fine = 16;
  return cut(lattice, gamma, {a + lattice.h, b + lattice.h}, [&](Vec2 at) {
    int inside = 0;
    for (int j = 0; j < fine; ++j)
      for (int i = 0; i < fine; ++i) {
        const double x = at.x + ((i + 0.5) / fine - 0.5) * lattice.h,
                     y = at.y + ((j + 0.5) / fine - 0.5) * lattice.h;
        inside += x * x / (a * a) + y * y / (b * b) < 1;
      }
    return inside / double(fine * fine);
  });
}

}  // namespace vortree::vortex
