#include "flow/initial/gaussian.hpp"
#include "flow/initial/settings.hpp"

namespace vortree::flow {
namespace {

std::vector<Patch> patches(const InitialSettings& i) {
  return {gaussian(*i.circulation, *i.core, *i.core)};
}

void hold(const InitialSettings& i, double sigma_0) {
  hold_wider("initial.core", *i.core, sigma_0);
}

}  // namespace

/// A round Gaussian of width `core`, which stays one while it decays.
const InitialFlow& lamb_oseen() {
  static const InitialFlow kind{{"lamb_oseen", {}}, "a Gaussian vortex", patches, hold};
  return kind;
}

}  // namespace vortree::flow
