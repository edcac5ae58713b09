#include "vortex/blobs/outflow.hpp"

#include <cmath>

namespace vortree::vortex {

namespace {

/// Takes away all blobs but those that `stays(i)` names.
Outflow remove_but(Blobs& blobs, auto stays) {
  Outflow gone;
  std::size_t left = 0;
  for (std::size_t i = 0; i < blobs.size(); ++i) {
    const Vec2 at = blobs.centre(i);
    if (stays(i))
      blobs.put(left++, at, blobs.gamma[i], blobs.core(i));
    else
      gone = gone + Outflow{blobs.gamma[i], blobs.gamma[i] * at, std::abs(blobs.gamma[i])};
  }
  blobs.resize(left);
  return gone;
}

}  // namespace

Outflow remove_outside(Blobs& blobs, const Box& box) {
  return remove_but(blobs, [&](std::size_t i) { return box.holds(blobs.centre(i)); });
}

Outflow remove_faint(Blobs& blobs, double faintest) {
  return remove_but(blobs, [&](std::size_t i) { return std::abs(blobs.gamma[i]) > faintest; });
}

}  // namespace vortree::vortex
