#include <cmath>
#include <numbers>

#include "base/rounded.hpp"
#include "flow/initial/gaussian.hpp"
#include "flow/initial/settings.hpp"

namespace vortree::flow {
namespace {

std::vector<Patch> patches(const InitialSettings& i) {
  const double a = *i.core, p = i.number("perturbation");
  return {{.circulation = *i.circulation,
           .half = {a, a},
           .area = std::numbers::pi * a * a,
           .weight =
               [a, p](Vec2 at, double sigma, double) {
                 const double s2 = a * a - sigma * sigma, bump = p * a * a / (s2 * s2);
                 return std::exp(-dot(at, at) / s2) * (1 + bump * (at.x * at.x - at.y * at.y));
               },
           .extent =
               [a](double faintest, double sigma, double) {
                 const double s2 = a * a - sigma * sigma;
                 // The bump is largest near 2 s; 3 s more cover what it lifts above the faintest.
                 const double reach = std::sqrt(-s2 * std::log(faintest)) + 3 * std::sqrt(s2);
                 return Vec2{reach, reach};
               }}};
}

void hold(const InitialSettings& i, double sigma_0) {
  hold_wider("initial.core", *i.core, sigma_0);
}

std::vector<std::string> doubts(const InitialSettings& i, double) {
  const double p = i.number("perturbation");
  if (std::abs(p) <= 2) return {};
  return {"initial.perturbation = " + rounded(p, 3) +
          ": the vortex is less than what perturbs it; 0.1 to 1 is right"};
}

}  // namespace

/// A Gaussian vortex of width a, `core`, with a quadrupole upon it,
///
///   omega  = gamma/(pi a^2) exp(-r^2/a^2) (1 + p (x^2 - y^2)/a^2),
///   weight = exp(-r^2/s^2) (1 + p (a^2/s^4) (x^2 - y^2)),   s^2 = a^2 - sigma^2.
///
/// For a perturbation p near 1 it becomes a tripole.
/// error   O(exp(-(pi sigma/h)^2)) relative, while a > sigma
/// source  Rossi, Lingevitch & Bernoff, Phys. Fluids 9 (1997)
const InitialFlow& tripole() {
  static const InitialFlow kind{
      {"tripole", {{"perturbation", anything, "", "p of the factor 1 + p (x^2 - y^2)/core^2"}}},
      "a Gaussian times a quadrupole",
      patches,
      hold,
      doubts};
  return kind;
}

}  // namespace vortree::flow
