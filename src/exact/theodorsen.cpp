#include "exact/theodorsen.hpp"

#include <cmath>
#include <numbers>

namespace vortree::exact {
namespace {

constexpr std::complex<double> i_unit{0, 1};

std::complex<double> hankel(double order, double k) {
  return {std::cyl_bessel_j(order, k), -std::cyl_neumann(order, k)};
}

}  // namespace

std::complex<double> theodorsen_function(double k) {
  const std::complex<double> one = hankel(1, k);
  return one / (one + i_unit * hankel(0, k));
}

std::complex<double> lift_of_plunge(double amplitude_over_half_chord, double k) {
  constexpr double pi = std::numbers::pi;
  return amplitude_over_half_chord * (pi * k * k - 2 * pi * k * i_unit * theodorsen_function(k));
}

}  // namespace vortree::exact
