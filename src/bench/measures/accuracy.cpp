#include "bench/measures/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "bench/measures/exact_kernel.hpp"
#include "fmm/geometry/units.hpp"

namespace vortree::bench {
namespace {

// Past this an exponential is below the last bit of a long double.
constexpr double core_fades = 50.0;

// A target so many extents away sees lengths whose squares doubles cannot hold.
constexpr double far_away = 1e70;

// Eight sources after eight, in fmm::Units; the last ones are filled up with some of no strength.
struct Packed {
  fmm::Units units;
  std::vector<double> x, y, gamma, sigma;
  double largest_core = 0.0;  // squared

  explicit Packed(const fmm::Sources& blobs) : units(fmm::Units::of(blobs)) {
    const auto scaled = [](std::span<const double> values, double factor) {
      std::vector<double> all(values.size());
      std::ranges::transform(values, all.begin(), [=](double value) { return value * factor; });
      return all;
    };
    x = scaled(blobs.x, units.per_length), y = scaled(blobs.y, units.per_length);
    gamma = scaled(blobs.gamma, units.per_gamma), sigma = scaled(blobs.sigma, units.per_length);
    for (const double s : sigma) largest_core = std::max(largest_core, s * s);
    const std::size_t room = padded(blobs.size());
    for (auto* column : {&x, &y, &gamma}) column->resize(room, 0.0);
  }
};

// Multiplies the weights of the lanes where a core shows by 1 - exp(-r^2/sigma^2).
Twice with_cores(const Twice& weight, const Twice& r2, const double* sigma, std::size_t lanes) {
  Twice core{fill(1.0), fill(0.0)};
  for (std::size_t i = 0; i < lanes; ++i) {
    const long double squared = static_cast<long double>(sigma[i]) * sigma[i];
    const long double r = static_cast<long double>(r2.high[i]) + r2.low[i];
    if (squared == 0 || r > core_fades * squared) continue;
    const long double value = -std::expm1(-r / squared);
    core.high[i] = static_cast<double>(value);
    core.low[i] = static_cast<double>(value - core.high[i]);
  }
  return weight * core;
}

struct ExactSum {
  long double u, v, contributions;

  // From Units, without the factor 1/(2 pi), to the user's; long doubles hold all of it.
  [[nodiscard]] ExactSum finished(const fmm::Units& units) const {
    const long double scale = units.per_length / (2 * std::numbers::pi_v<long double>) /
                              static_cast<long double>(units.per_gamma);
    return {u * scale, v * scale, contributions * scale};
  }
};

// What is far away sees the pairs' differences by long doubles, whose squares do not overflow.
ExactSum sum_from_afar(const Packed& sources, std::size_t n, long double x, long double y) {
  ExactSum sum{};
  for (std::size_t j = 0; j < n; ++j) {
    const long double dx = x - sources.x[j], dy = y - sources.y[j], r2 = dx * dx + dy * dy;
    long double weight = sources.gamma[j] / r2;
    if (!sources.sigma.empty() && sources.sigma[j] > 0.0) {
      weight *= -std::expm1(-r2 / sources.sigma[j] / sources.sigma[j]);
    }
    sum.u -= weight * dy, sum.v += weight * dx;
    sum.contributions += std::abs(weight) * std::sqrt(r2);
  }
  return sum;
}

long double total(const Twice& lanes) {
  long double sum = 0;
  for (int i = 0; i < lane_count; ++i)
    sum += static_cast<long double>(lanes.high[i]) + lanes.low[i];
  return sum;
}

ExactSum sum_directly(const Packed& sources, double x, double y) {
  const std::span<const double> sigma = sources.sigma;
  Twice u{}, v{};
  Lanes contributions{};
  for (std::size_t j = 0; j < sources.x.size(); j += lane_count) {
    const Twice dx = exact_sum(fill(x), -load(&sources.x[j]));
    const Twice dy = exact_sum(fill(y), -load(&sources.y[j]));
    Twice r2 = dx * dx + dy * dy;
    const auto apart = r2.high > 0.0;
    r2.high = apart ? r2.high : fill(1.0);
    const Lanes gamma = apart ? load(&sources.gamma[j]) : fill(0.0);
    Twice weight = inverse(r2) * Twice{gamma, fill(0.0)};
    if (!sigma.empty() && largest(-r2.high) > -core_fades * sources.largest_core)
      weight =
          with_cores(weight, r2, &sigma[j], std::min<std::size_t>(lane_count, sigma.size() - j));
    u = u + weight * dy;
    v = v + weight * dx;
    Lanes distance;
    for (int i = 0; i < lane_count; ++i) distance[i] = std::sqrt(r2.high[i]);
    contributions += magnitude(weight.high) * distance;
  }
  return {-total(u), total(v), sum(contributions)};
}

std::vector<std::size_t> random_sample(std::size_t n, std::size_t size) {
  std::vector<std::size_t> all(n), sample;
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::ranges::sample(all, std::back_inserter(sample), std::min(n, size),
                      std::mt19937_64{20260101});
  return sample;
}

}  // namespace

Exact exact_velocity(const fmm::Sources& sources, const fmm::Targets& targets, std::size_t sample) {
  Exact exact;
  exact.targets = random_sample(targets.size(), sample);
  const std::size_t n = exact.targets.size();
  const Packed packed(sources);
  exact.u.resize(n);
  exact.v.resize(n);
  exact.contributions.resize(n);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = exact.targets[k];
    const long double unit = packed.units.per_length;
    const long double x = targets.x[i] * unit, y = targets.y[i] * unit;
    const bool far = std::max(std::abs(x), std::abs(y)) > far_away;
    const ExactSum sum =
        (far ? sum_from_afar(packed, sources.size(), x, y)
             : sum_directly(packed, static_cast<double>(x), static_cast<double>(y)))
            .finished(packed.units);
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
  long double missed = 0, whole = 0, contributions = 0;
  std::vector<double> pointwise;
  for (std::size_t k = 0; k < error.targets; ++k) {
    const std::size_t i = exact.targets[k];
    const long double du = u[i] - exact.u[k], dv = v[i] - exact.v[k];
    const long double difference2 = du * du + dv * dv;
    missed += difference2;
    contributions += exact.contributions[k] * exact.contributions[k];
    whole += exact.u[k] * exact.u[k] + exact.v[k] * exact.v[k];
    const auto local =
        static_cast<double>(difference2 == 0 ? 0 : std::sqrt(difference2) / exact.contributions[k]);
    pointwise.push_back(std::isnan(local) ? INFINITY : local);
  }
  if (contributions != 0) error.condition = static_cast<double>(std::sqrt(contributions / whole));
  if (missed != 0) error.relative_l2 = static_cast<double>(std::sqrt(missed / whole));
  if (std::isnan(error.relative_l2)) error.relative_l2 = INFINITY;
  std::ranges::sort(pointwise);
  error.p99 = pointwise[(pointwise.size() * 99 + 99) / 100 - 1];
  error.max = pointwise.back();
  return error;
}

}  // namespace vortree::bench
