#include "bench/rivals/velocity/vortex_spectrum.hpp"

#include <math.h>

#include <cmath>
#include <cstddef>

namespace vortree::bench {
namespace {

// Taylor coefficients a_n of J0 about z, from z f'' + f' + z f = 0:
//   (n + 2)(n + 1) z a_(n+2) + (n + 1)^2 a_(n+1) + z a_n + a_(n-1) = 0
void expand(double z, double* a, int count) {
  if (z == 0.0) {
    for (int n = 0; n < count; ++n) a[n] = 0.0;
    double term = 1.0;
    for (int n = 0; n < count; n += 2) {
      a[n] = term;
      term *= -1.0 / ((n + 2.0) * (n + 2.0));
    }
    return;
  }
  a[0] = ::j0(z);
  a[1] = -::j1(z);
  for (int n = 0; n + 2 < count; ++n) {
    const double before = n > 0 ? a[n - 1] : 0.0;
    a[n + 2] =
        -((n + 1.0) * (n + 1.0) * a[n + 1] + z * a[n] + before) / ((n + 2.0) * (n + 1.0) * z);
  }
}

}  // namespace

VortexSpectrum::VortexSpectrum(double reach, double largest) : reach_(reach) {
  const auto nodes = static_cast<std::size_t>(reach * largest * per_unit) + 2;
  terms_.resize(nodes * count);
#pragma omp parallel for schedule(static)
  for (std::size_t node = 0; node < nodes; ++node) {
    double a[count];
    expand(static_cast<double>(node) / per_unit, a, count);
    double scale = 1.0;
    for (int n = 0; n < count; ++n) {
      terms_[node * count + count - 1 - n] = (n == 0 ? 1.0 - a[0] : -a[n]) * scale;
      scale /= per_unit;
    }
  }
}

}  // namespace vortree::bench
