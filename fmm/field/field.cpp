#include "fmm/field/field.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fmm/lists/interactions.hpp"

namespace vortree::fmm {
namespace {

/// ln(x^2 + y^2) of what cannot be squared.
double log_square(double x, double y) {
  const double most = std::max(std::abs(x), std::abs(y));
  const double part = std::min(std::abs(x), std::abs(y)) / most;
  return 2.0 * std::log(most) + std::log1p(part * part);
}

}  // namespace

double FieldGradient::reach2(double tolerance) {
  const double own = core_reach2(tolerance);
  return own + std::log1p(own + std::log1p(own));
}

double StreamFunction::reach2(double tolerance) {
  return core_reach2(tolerance);
}

double log_unit(const Units& units) {
  return 2.0 * std::log(units.per_length);
}

void finish_gradient(const Units& units, std::span<double> ux, std::span<double> uy,
                     std::span<double> vx) {
  const int power = 2 * std::ilogb(units.per_length) - std::ilogb(units.per_gamma);
  const double third = std::ldexp(1.0, power / 3);  // in three parts: each is normal
  const double rest = std::ldexp(1.0, power - 2 * (power / 3));
  const double first = third / (2.0 * std::numbers::pi);
  for (std::size_t i = 0; i < ux.size(); ++i) {
    const double along = ux[i] * first, across = uy[i] * first, rotation = vx[i] * first;
    ux[i] = along * third * rest;
    uy[i] = (across - rotation) * third * rest;
    vx[i] = (across + rotation) * third * rest;
  }
}

/// Lengths l in the user's units are l per_length in Units, which adds ln per_length to every
/// logarithm.
double finish_stream_function(const Units& units, double all, const Targets& targets,
                              std::span<double> psi) {
  const double unit = log_unit(units);
  double found = 0.0;
  for (std::size_t i = 0; i < psi.size(); ++i) {
    const double x = targets.x[i], y = targets.y[i];
    const bool beyond =
        std::max(std::abs(x * units.per_length), std::abs(y * units.per_length)) > Units::far_away;
    const double sum = beyond ? all * log_square(x, y) : psi[i] - all * unit;
    found += sum * sum;
    psi[i] = std::ldexp((0.0 - sum) / (4.0 * std::numbers::pi), -std::ilogb(units.per_gamma));
  }
  return found;
}

}  // namespace vortree::fmm
