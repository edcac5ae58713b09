#include "vortex/transport/particle_exchange.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "tree/base/told.hpp"
#include "vortex/adapt/bins.hpp"

namespace vortree::vortex {
namespace {

constexpr double reach = 5;  // of epsilon; exp(-25) = 1e-11

/// A gamma.
std::vector<double> rate(const Blobs& blobs, const Bins& bins, const std::vector<double>& gamma,
                         double factor, double epsilon) {
  const auto n = static_cast<std::ptrdiff_t>(blobs.size());
  const double inverse = 1 / (epsilon * epsilon), far = reach * reach;
  std::vector<double> rate(n);
#pragma omp parallel for schedule(dynamic, 64)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    double sum = 0;
    bins.runs_near(blobs.centre(i), reach * epsilon, [&](std::uint32_t first, std::uint32_t last) {
      for (std::uint32_t k = first; k < last; ++k) {
        const std::uint32_t j = bins.order()[k];
        const Vec2 d = blobs.centre(i) - blobs.centre(j);
        const double q = inverse * dot(d, d);
        if (q < far) sum += (gamma[j] - gamma[i]) * std::exp(-q);
      }
    });
    rate[i] = factor * sum;
  }
  return rate;
}

}  // namespace

void exchange_strength(Blobs& blobs, double nu, double dt, double epsilon, double area) {
  if (nu * dt > 0.5 * epsilon * epsilon)
    throw std::invalid_argument("particle strength exchange with nu dt = " + tree::told(nu * dt) +
                                " and cores of " + tree::told(epsilon) +
                                "; it is stable for nu dt <= core^2/2");
  const Bins bins(blobs.x, blobs.y, 2 * epsilon);
  const double e2 = epsilon * epsilon, factor = 4 * std::numbers::inv_pi * nu * area / (e2 * e2);
  const std::vector<double> first = rate(blobs, bins, blobs.gamma, factor, epsilon);
  const std::vector<double> second = rate(blobs, bins, first, factor, epsilon);
  for (std::size_t i = 0; i < blobs.size(); ++i)
    blobs.gamma[i] += dt * first[i] + 0.5 * dt * dt * second[i];
}

}  // namespace vortree::vortex
