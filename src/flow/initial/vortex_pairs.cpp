#include "base/rounded.hpp"
#include "flow/initial/gaussian.hpp"
#include "flow/initial/settings.hpp"
#include "tree/base/told.hpp"

namespace vortree::flow {
namespace {

/// One vortex on the left, and one of circulation `right` on the right.
std::vector<Patch> two(const InitialSettings& i, double right) {
  const double half = 0.5 * i.number("separation");
  return {gaussian(*i.circulation, *i.core, *i.core, {-half, 0}),
          gaussian(right, *i.core, *i.core, {half, 0})};
}

std::vector<Patch> alike(const InitialSettings& i) {
  return two(i, *i.circulation);
}

std::vector<Patch> opposite(const InitialSettings& i) {
  return two(i, -*i.circulation);
}

void hold(const InitialSettings& i, double sigma_0) {
  constexpr double most = 1e5;  // cores
  hold_wider("initial.core", *i.core, sigma_0);
  if (sigma_0 == 0) return;
  const double apart = i.number("separation");
  const std::string is = "initial.separation is " + tree::told(apart) + "; ",
                    core = "cores.sigma_0 = " + tree::told(sigma_0);
  if (apart < sigma_0)
    throw Refused("initial.separation",
                  is + "two vortices are at least a core, " + core + ", apart");
  if (apart > most * sigma_0)
    throw Refused("initial.separation", is + "vortices of " + core + " can be " +
                                            tree::told(most * sigma_0) + " apart at most");
}

std::vector<std::string> doubts(const InitialSettings& i, double) {
  const double apart = i.number("separation");
  if (apart >= 2 * *i.core) return {};
  return {"initial.separation = " + rounded(apart, 3) + ": two vortices of width " +
          rounded(*i.core, 3) + " so near are one from the start; " + rounded(5 * *i.core, 2) +
          " parts them"};
}

std::vector<Dimension> separation() {
  return {{"separation", positive, "L", "distance of the two along x"}};
}

}  // namespace

/// Two Gaussian vortices, each of `circulation`, `separation` apart along x.
const InitialFlow& corotating_pair() {
  static const InitialFlow kind{
      {"corotating_pair", separation()}, "two Gaussians alike", alike, hold, doubts};
  return kind;
}

/// The same, of opposite signs; it travels along +y.
const InitialFlow& dipole() {
  static const InitialFlow kind{{"dipole", separation()},
                                "two Gaussians of opposite signs, which travel along +y",
                                opposite,
                                hold,
                                doubts};
  return kind;
}

}  // namespace vortree::flow
