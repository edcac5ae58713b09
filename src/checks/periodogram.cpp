#include "checks/periodogram.hpp"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>

namespace vortree::checks {
namespace {

constexpr std::size_t padding = 4;  // length with zeros, of the samples

double hann(std::size_t i, std::size_t n) {
  const double s = std::sin(std::numbers::pi * (static_cast<double>(i) + 0.5) / n);
  return s * s;
}

double mean_of(std::span<const double> samples) {
  return std::accumulate(samples.begin(), samples.end(), 0.0) / static_cast<double>(samples.size());
}

/// Of what is beside the mean, so many cycles a sample.
std::complex<double> component(std::span<const double> samples, double frequency) {
  const double mean = mean_of(samples);
  std::complex<double> sum = 0;
  for (std::size_t i = 0; i < samples.size(); ++i)
    sum += hann(i, samples.size()) * (samples[i] - mean) *
           std::polar(1.0, -2 * std::numbers::pi * frequency * static_cast<double>(i));
  return sum;
}

}  // namespace

std::vector<double> power_spectrum(std::span<const double> samples) {
  const std::size_t n = samples.size(), length = padding * n;
  if (n < 8)
    throw std::invalid_argument("a spectrum of " + std::to_string(n) +
                                " samples; at least 8 were expected");
  const double mean = mean_of(samples);
  std::vector<double> values(length), transform(2 * (length / 2 + 1));
  const auto destroy = [](fftw_plan plan) { fftw_destroy_plan(plan); };
  const std::unique_ptr<fftw_plan_s, decltype(destroy)> plan(
      fftw_plan_dft_r2c_1d(static_cast<int>(length), values.data(),
                           reinterpret_cast<fftw_complex*>(transform.data()), FFTW_ESTIMATE),
      destroy);
  for (std::size_t i = 0; i < n; ++i) values[i] = hann(i, n) * (samples[i] - mean);
  fftw_execute(plan.get());
  std::vector<double> power(length / 2 + 1);
  for (std::size_t k = 0; k < power.size(); ++k)
    power[k] = transform[2 * k] * transform[2 * k] + transform[2 * k + 1] * transform[2 * k + 1];
  return power;
}

double dominant_frequency(std::span<const double> samples, double dt) {
  const std::vector<double> power = power_spectrum(samples);
  const auto k = static_cast<std::size_t>(std::ranges::max_element(power) - power.begin());
  double at = static_cast<double>(k);
  if (k > 0 && k + 1 < power.size() && power[k - 1] > 0 && power[k + 1] > 0) {
    const double a = std::log(power[k - 1]), b = std::log(power[k]), c = std::log(power[k + 1]);
    if (a + c < 2 * b) at += 0.5 * (a - c) / (a - 2 * b + c);
  }
  return at / (static_cast<double>(padding * samples.size()) * dt);
}

double phase_ahead(std::span<const double> signal, std::span<const double> of, double dt) {
  const double cycles = dt * dominant_frequency(of, dt);
  return std::arg(component(signal, cycles) * std::conj(component(of, cycles)));
}

}  // namespace vortree::checks
