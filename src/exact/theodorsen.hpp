#pragma once

#include <complex>

namespace vortree::exact {

/// Lift of a flat plate that plunges a little in a stream, its wake left along the stream.
///
/// For y = amplitude exp(i omega t) across the stream, b half the chord, k = omega b/U:
///
///   C_L = amplitude/b (pi k^2 - 2 pi i k C(k)) exp(i omega t),
///   C(k) = H1/(H1 + i H0),   H Hankel functions of the second kind
///
/// the added mass, and the circulation delayed by the wake. k > 0.
/// source  Theodorsen, NACA Report 496 (1935)
std::complex<double> theodorsen_function(double k);
std::complex<double> lift_of_plunge(double amplitude_over_half_chord, double k);

}  // namespace vortree::exact
