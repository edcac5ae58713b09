#pragma once

#include <span>
#include <vector>

namespace vortree::checks {

/// Power of a signal sampled at even times, by frequency: |sum_n w_n (a_n - mean) exp(-2 pi i k
/// n/N)|^2 with Hann's window w, N the samples and as many zeros again three times over (so that
/// peaks are seen between the bins); entry k is the frequency k/(4 n dt).
/// throws  std::invalid_argument for fewer than 8 samples
std::vector<double> power_spectrum(std::span<const double> samples);

/// The frequency of the highest peak, dt the time between samples: a parabola through the logarithm
/// of the three highest values.
/// error  a hundredth of 1/(n dt) for a lone sinusoid of more than four periods
double dominant_frequency(std::span<const double> samples, double dt);

/// By how much a signal is ahead of another of as many samples, at the dominant frequency f of
/// that:
///
///   arg A/B,   A = sum_n w_n (a_n - mean) exp(-2 pi i f n dt), w Hann's window; B likewise
///
/// in radians, from -pi to pi.
double phase_ahead(std::span<const double> signal, std::span<const double> of, double dt);

}  // namespace vortree::checks
