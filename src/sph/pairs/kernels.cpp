#include "sph/pairs/kernels.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "sph/pairs/kernel_shapes.hpp"

namespace vortree::sph {
namespace {

using std::numbers::pi;

double raised(double base, int exponent) {
  double product = 1;
  for (; exponent > 0; --exponent) product *= base;
  return product;
}

template <class Use>
double of_shape(Kernel kernel, int dimensions, const Use& use) {
  return dimensions == 1 ? with_shape<1>(kernel, use) : with_shape<2>(kernel, use);
}

// What a Gaussian cut off at q = 3 still integrates to.
double gaussian_integral(int d) {
  const double edge = 3, root = std::sqrt(pi), cut = std::exp(-edge * edge);
  if (d == 1) return root * std::erf(edge);
  if (d == 2) return pi * (1 - cut);
  return pi * (root * std::erf(edge) - 2 * edge * cut);
}

}  // namespace

std::string_view name_of(Kernel kernel) {
  constexpr std::array<std::string_view, every_kernel.size()> names{
      "wendland_c2",    "wendland_c4", "wendland_c6", "cubic_spline",
      "quintic_spline", "gaussian",    "quadratic",   "bell"};
  return names[static_cast<std::size_t>(kernel)];
}

double support(Kernel kernel) {
  return with_shape<2>(kernel, [](auto shape) { return shape.support; });
}

double norm(Kernel kernel, int dimensions) {
  if (dimensions < 1 || dimensions > 3) {
    throw std::invalid_argument("norm: " + std::to_string(dimensions) +
                                " dimensions; kernels are normalised in 1, 2 and 3");
  }
  const auto pick = [=](double one, double two, double three) {
    return dimensions == 1 ? one : dimensions == 2 ? two : three;
  };
  switch (kernel) {
    case Kernel::wendland_c2:
      return pick(5.0 / 8, 7 / (4 * pi), 21 / (16 * pi));
    case Kernel::wendland_c4:
      return pick(3.0 / 4, 9 / (4 * pi), 495 / (256 * pi));
    case Kernel::wendland_c6:
      return pick(55.0 / 64, 78 / (28 * pi), 1365 / (512 * pi));
    case Kernel::cubic_spline:
      return pick(1.0 / 6, 5 / (14 * pi), 1 / (4 * pi));
    case Kernel::quintic_spline:
      return pick(1.0 / 120, 7 / (478 * pi), 1 / (120 * pi));
    case Kernel::gaussian:
      return 1 / gaussian_integral(dimensions);
    case Kernel::quadratic:
      return pick(3.0 / 4, 3 / (2 * pi), 15 / (16 * pi));
    default:
      return pick(5.0 / 4, 5 / pi, 105 / (16 * pi));
  }
}

double shape(Kernel kernel, int dimensions, double q) {
  return of_shape(kernel, dimensions, [=](auto shape) { return shape.shape(q); });
}

double slope(Kernel kernel, int dimensions, double q) {
  return q * of_shape(kernel, dimensions, [=](auto shape) { return shape.slope_over_q(q); });
}

double value(Kernel kernel, int dimensions, double r, double h) {
  return norm(kernel, dimensions) * shape(kernel, dimensions, r / h) / raised(h, dimensions);
}

double derivative(Kernel kernel, int dimensions, double r, double h) {
  return norm(kernel, dimensions) * slope(kernel, dimensions, r / h) / raised(h, dimensions + 1);
}

}  // namespace vortree::sph
