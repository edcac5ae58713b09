#include "exact/theodorsen.hpp"

#include <cmath>
#include <numbers>

namespace vortree::exact {
namespace {

using Complex = std::complex<double>;
constexpr Complex i_unit{0, 1};

Complex hankel(double order, double k) {
  return {std::cyl_bessel_j(order, k), -std::cyl_neumann(order, k)};
}

}  // namespace

Complex theodorsen_function(double k) {
  const Complex one = hankel(1, k);
  return one / (one + i_unit * hankel(0, k));
}

Complex lift_of_plunge(double amplitude_over_half_chord, double k) {
  constexpr double pi = std::numbers::pi;
  return amplitude_over_half_chord * (pi * k * k - 2 * pi * k * i_unit * theodorsen_function(k));
}

}  // namespace vortree::exact
