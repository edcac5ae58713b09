#include "exact/spinning_cylinder.hpp"

#include <cmath>
#include <numbers>

namespace vortree::exact {
namespace {

/// 2/pi int_0^inf f(k) dk by the trapezoid rule in log k: f falls off as exp(-(k/widest)^2),
/// and near 0 as a power of k or as 1/log^2.
double integral(double widest, auto f) {
  constexpr int points = 2000;
  const double first = std::log(1e-9 * widest), last = std::log(6.5 * widest),
               step = (last - first) / points;
  double sum = 0;
  for (int i = 0; i <= points; ++i) {
    const double k = std::exp(first + i * step);
    sum += (i == 0 || i == points ? 0.5 : 1.0) * k * f(k);
  }
  return 2 / std::numbers::pi * step * sum;
}

double j(int n, double x) {
  return std::cyl_bessel_j(n, x);
}

double y(int n, double x) {
  return std::cyl_neumann(n, x);
}

/// (J_n(kr) Y1(kR) - Y_n(kr) J1(kR)) exp(-nu k^2 t)/(J1(kR)^2 + Y1(kR)^2).
double mode(int n, double k, double r, double t, const SpinningCylinder& c) {
  const double j1 = j(1, k * c.radius), y1 = y(1, k * c.radius);
  return std::exp(-c.nu * k * k * t) * (j(n, k * r) * y1 - y(n, k * r) * j1) / (j1 * j1 + y1 * y1);
}

}  // namespace

double SpinningCylinder::swirl(double r, double t) const {
  const double widest = 1 / std::sqrt(nu * t);
  const double left = integral(widest, [&](double k) { return mode(1, k, r, t, *this) / k; });
  return rate * radius * (radius / r + left);
}

double SpinningCylinder::vorticity(double r, double t) const {
  const double widest = 1 / std::sqrt(nu * t);
  return rate * radius * integral(widest, [&](double k) { return mode(0, k, r, t, *this); });
}

}  // namespace vortree::exact
