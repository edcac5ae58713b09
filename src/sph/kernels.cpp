#include "sph/kernels.hpp"

#include <cmath>
#include <initializer_list>
#include <numbers>
#include <stdexcept>
#include <string>

namespace vortree::sph {
namespace {

using std::numbers::pi;

double power(double base, int exponent) {
  double product = 1;
  for (; exponent > 0; --exponent) product *= base;
  return product;
}

struct ValueAndSlope {
  double value, slope;
};

// c[0] + c[1] q + c[2] q^2 + ...
ValueAndSlope polynomial(std::initializer_list<double> c, double q) {
  ValueAndSlope p{0, 0};
  for (auto k = std::rbegin(c); k != std::rend(c); ++k) {
    p = {p.value * q + *k, p.slope * q + p.value};
  }
  return p;
}

// (1 - q/2)^n times a polynomial, q < 2.
ValueAndSlope wendland(int n, std::initializer_list<double> c, double q) {
  const auto p = polynomial(c, q);
  const double t = 1 - q / 2, below = power(t, n - 1);
  return {below * t * p.value, below * (t * p.slope - 0.5 * n * p.value)};
}

// sum_k weight_k (edge_k - q)^n, terms beyond their edge zero.
ValueAndSlope spline(int n, double edge, std::initializer_list<double> weights, double q) {
  ValueAndSlope sum{0, 0};
  for (const double weight : weights) {
    const double t = edge - q;
    if (t <= 0) break;
    sum.value += weight * power(t, n);
    sum.slope -= weight * n * power(t, n - 1);
    edge -= 1;
  }
  return sum;
}

ValueAndSlope evaluate(Kernel kernel, int d, double q) {
  if (q >= support(kernel)) return {0, 0};
  switch (kernel) {
    case Kernel::wendland_c2:
      return d == 1 ? wendland(3, {1, 1.5}, q) : wendland(4, {1, 2}, q);
    case Kernel::wendland_c4:
      return d == 1 ? wendland(5, {1, 2.5, 2}, q) : wendland(6, {1, 3, 35.0 / 12}, q);
    case Kernel::wendland_c6:
      return d == 1 ? wendland(7, {1, 3.5, 4.75, 2.625}, q) : wendland(8, {1, 4, 6.25, 4}, q);
    case Kernel::cubic_spline:
      return spline(3, 2, {1, -4}, q);
    case Kernel::quintic_spline:
      return spline(5, 3, {1, -6, 15}, q);
    case Kernel::gaussian:
      return {std::exp(-q * q), -2 * q * std::exp(-q * q)};
    case Kernel::quadratic:
      return polynomial({1, -1, 0.25}, q);
    default: {
      const double t = 1 - q;
      return {(1 + 3 * q) * t * t * t, -12 * q * t * t};
    }
  }
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
  switch (kernel) {
    case Kernel::quintic_spline:
    case Kernel::gaussian:
      return 3;
    case Kernel::bell:
      return 1;
    default:
      return 2;
  }
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
  return evaluate(kernel, dimensions, q).value;
}

double slope(Kernel kernel, int dimensions, double q) {
  return evaluate(kernel, dimensions, q).slope;
}

double value(Kernel kernel, int dimensions, double r, double h) {
  return norm(kernel, dimensions) * shape(kernel, dimensions, r / h) / power(h, dimensions);
}

double derivative(Kernel kernel, int dimensions, double r, double h) {
  return norm(kernel, dimensions) * slope(kernel, dimensions, r / h) / power(h, dimensions + 1);
}

}  // namespace vortree::sph
