#include "flow/initial/initial_flow.hpp"

#include <algorithm>
#include <stdexcept>

// Each is `const InitialFlow& NAME()` in a file of this folder.
// clang-format off
#define VORTREE_INITIAL_FLOWS(kind) \
  kind(lamb_oseen) \
  kind(gaussian_ellipse) \
  kind(kirchhoff_ellipse) \
  kind(corotating_pair) \
  kind(dipole) \
  kind(tripole) \
  kind(taylor_green)
// clang-format on

namespace vortree::flow {

#define DECLARED(kind) const InitialFlow& kind();
VORTREE_INITIAL_FLOWS(DECLARED)
#undef DECLARED

InitialFlows initial_flows() {
#define LISTED(kind) &kind(),
  static const InitialFlow* const all[] = {VORTREE_INITIAL_FLOWS(LISTED)};
#undef LISTED
  return all;
}

const InitialFlow& initial_flow(std::string_view name) {
  const InitialFlows all = initial_flows();
  const auto found = std::ranges::find(all, name, &Kind::name);
  if (found == all.end()) throw std::out_of_range("no initial flow " + std::string(name));
  return **found;
}

Dimensions initial_numbers() {
  return dimensions_of(as_kinds(initial_flows()));
}

}  // namespace vortree::flow
