#include "vortex/blobs/outflow.hpp"

#include <cmath>

namespace vortree::vortex {

namespace {

/// Takes away all blobs but those that `stays(i)` names.
Retired retire_but(Blobs& blobs, auto stays) {
  Retired gone;
  std::size_t left = 0;
  for (std::size_t i = 0; i < blobs.size(); ++i) {
    const Vec2 at = blobs.centre(i);
    if (stays(i))
      blobs.put(left++, at, blobs.gamma[i], blobs.core(i));
    else
      gone = gone + Retired{blobs.gamma[i], blobs.gamma[i] * at, std::abs(blobs.gamma[i])};
  }
  blobs.resize(left);
  return gone;
}

}  // namespace

Retired retire(Blobs& blobs, const Box& box) {
  return retire_but(blobs, [&](std::size_t i) { return box.holds(blobs.centre(i)); });
}

Retired retire(Blobs& blobs, double faintest) {
  return retire_but(blobs, [&](std::size_t i) { return std::abs(blobs.gamma[i]) > faintest; });
}

}  // namespace vortree::vortex
