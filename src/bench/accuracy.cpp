#include "bench/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace vortree::bench {
namespace {

struct Sum {
  long double u = 0, v = 0;
  double contributions = 0;
};

// 1 - exp(-q); past 50 the exponential is below the last bit of a long double.
long double core(long double q) {
  return q < 50 ? -std::expm1(-q) : 1.0L;
}

Sum sum_directly(const fmm::Blobs& sources, double x, double y) {
  Sum sum;
  for (std::size_t j = 0; j < sources.size(); ++j) {
    const long double dx = static_cast<long double>(x) - sources.x[j];
    const long double dy = static_cast<long double>(y) - sources.y[j];
    const long double r2 = dx * dx + dy * dy;
    if (r2 == 0) continue;
    long double weight = sources.gamma[j] / r2;
    if (const long double sigma = sources.sigma.empty() ? 0 : sources.sigma[j]; sigma > 0)
      weight *= core(r2 / (sigma * sigma));
    sum.u -= weight * dy;
    sum.v += weight * dx;
    sum.contributions += std::abs(static_cast<double>(weight)) * std::sqrt(static_cast<double>(r2));
  }
  const long double scale = 1 / (2 * std::numbers::pi_v<long double>);
  return {sum.u * scale, sum.v * scale, sum.contributions * static_cast<double>(scale)};
}

std::vector<std::size_t> random_sample(std::size_t n, std::size_t size) {
  std::vector<std::size_t> all(n), sample;
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::ranges::sample(all, std::back_inserter(sample), std::min(n, size),
                      std::mt19937_64{20260101});
  return sample;
}

}  // namespace

Exact exact_velocity(const fmm::Blobs& sources, const fmm::Targets& targets, std::size_t sample) {
  Exact exact;
  exact.targets = random_sample(targets.size(), sample);
  const std::size_t n = exact.targets.size();
  exact.u.resize(n);
  exact.v.resize(n);
  exact.contributions.resize(n);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = exact.targets[k];
    const Sum sum = sum_directly(sources, targets.x[i], targets.y[i]);
    exact.u[k] = sum.u;
    exact.v[k] = sum.v;
    exact.contributions[k] = sum.contributions;
  }
  return exact;
}

VelocityError velocity_error(const Exact& exact, std::span<const double> u,
                             std::span<const double> v) {
  VelocityError error{.targets = exact.targets.size()};
  if (error.targets == 0) return error;
  long double missed = 0, whole = 0;
  std::vector<double> pointwise;
  for (std::size_t k = 0; k < error.targets; ++k) {
    const std::size_t i = exact.targets[k];
    const long double du = u[i] - exact.u[k], dv = v[i] - exact.v[k];
    const long double difference2 = du * du + dv * dv;
    missed += difference2;
    whole += exact.u[k] * exact.u[k] + exact.v[k] * exact.v[k];
    const double local = difference2 == 0
                             ? 0.0
                             : std::sqrt(static_cast<double>(difference2)) / exact.contributions[k];
    pointwise.push_back(std::isnan(local) ? INFINITY : local);
  }
  if (missed != 0) error.relative_l2 = static_cast<double>(std::sqrt(missed / whole));
  if (std::isnan(error.relative_l2)) error.relative_l2 = INFINITY;
  std::ranges::sort(pointwise);
  error.p99 = pointwise[(pointwise.size() * 99 + 99) / 100 - 1];
  error.max = pointwise.back();
  return error;
}

}  // namespace vortree::bench
