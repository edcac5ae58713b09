#include "flow/initial/gaussian.hpp"
#include "flow/initial/settings.hpp"

namespace vortree::flow {
namespace {

std::vector<Patch> patches(const InitialSettings& i) {
  return {gaussian(*i.circulation, *i.core, i.number("core_across"))};
}

void hold(const InitialSettings& i, double sigma_0) {
  hold_wider("initial.core", *i.core, sigma_0);
  hold_wider("initial.core_across", i.number("core_across"), sigma_0);
}

}  // namespace

/// An elliptical Gaussian, `core` wide along x and `core_across` along y.
const InitialFlow& gaussian_ellipse() {
  static const InitialFlow kind{
      {"gaussian_ellipse", {{"core_across", positive, "L", "half its width along y"}}},
      "an elliptic Gaussian",
      patches,
      hold};
  return kind;
}

}  // namespace vortree::flow
