#include "app/verify.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

namespace vortree::app {
namespace {

struct Exact {
  long double u = 0, v = 0, contributions = 0;
};

// 1 - exp(-q); past 50 the exponential is below the last bit of a long double.
long double core(long double q) {
  return q < 50 ? -std::expm1(-q) : 1.0L;
}

Exact sum_directly(const fmm::Blobs& sources, double x, double y) {
  Exact sum;
  for (std::size_t j = 0; j < sources.size(); ++j) {
    const long double dx = static_cast<long double>(x) - sources.x[j];
    const long double dy = static_cast<long double>(y) - sources.y[j];
    const long double r2 = dx * dx + dy * dy;
    if (r2 == 0) continue;
    long double weight = sources.gamma[j] / (2 * std::numbers::pi_v<long double> * r2);
    if (const long double sigma = sources.sigma.empty() ? 0 : sources.sigma[j]; sigma > 0)
      weight *= core(r2 / (sigma * sigma));
    sum.u -= weight * dy;
    sum.v += weight * dx;
    sum.contributions += std::abs(weight) * std::sqrt(r2);
  }
  return sum;
}

std::vector<std::size_t> random_sample(std::size_t n, std::size_t size) {
  std::vector<std::size_t> all(n), sample;
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::ranges::sample(all, std::back_inserter(sample), std::min(n, size),
                      std::mt19937_64{20260101});
  return sample;
}

}  // namespace

VelocityError velocity_error(fmm::Blobs sources, fmm::Targets targets, std::span<const double> u,
                             std::span<const double> v, std::size_t sample_size) {
  const auto sample = random_sample(targets.size(), sample_size);
  std::vector<long double> difference2(sample.size()), length2(sample.size());
  std::vector<double> pointwise(sample.size());
#pragma omp parallel for schedule(dynamic)
  for (std::size_t k = 0; k < sample.size(); ++k) {
    const std::size_t i = sample[k];
    const Exact exact = sum_directly(sources, targets.x[i], targets.y[i]);
    const long double du = u[i] - exact.u, dv = v[i] - exact.v;
    difference2[k] = du * du + dv * dv;
    length2[k] = exact.u * exact.u + exact.v * exact.v;
    pointwise[k] = difference2[k] == 0 ? 0 : std::sqrt(difference2[k]) / exact.contributions;
  }
  VelocityError error{.targets = sample.size()};
  if (sample.empty()) return error;
  const auto total = [](const auto& terms) {
    return std::accumulate(terms.begin(), terms.end(), 0.0L);
  };
  if (const long double missed = total(difference2); missed != 0)
    error.relative_l2 = static_cast<double>(std::sqrt(missed / total(length2)));
  // Not a number counts as infinitely wrong; a comparison would lose it.
  for (double& value : pointwise)
    if (std::isnan(value)) value = INFINITY;
  std::ranges::sort(pointwise);
  error.p99 = pointwise[(pointwise.size() * 99 + 99) / 100 - 1];
  error.max = pointwise.back();
  return error;
}

}  // namespace vortree::app
