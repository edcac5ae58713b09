#include "vortex/blobs/outflow.hpp"

#include <cmath>

namespace vortree::vortex {

namespace {

/// Takes away all blobs but those that `stays(i)` names, and hands them out.
Blobs take_but(Blobs& blobs, auto stays) {
  Blobs gone;
  std::size_t left = 0;
  for (std::size_t i = 0; i < blobs.size(); ++i) {
    const Vec2 at = blobs.centre(i);
    if (stays(i))
      blobs.put(left++, at, blobs.gamma[i], blobs.core(i));
    else
      gone.append(at, blobs.gamma[i], blobs.core(i));
  }
  blobs.resize(left);
  return gone;
}

}  // namespace

Outflow account_of(const Blobs& blobs) {
  Outflow sum;
  for (std::size_t i = 0; i < blobs.size(); ++i)
    sum = sum + Outflow{blobs.gamma[i], blobs.gamma[i] * blobs.centre(i), std::abs(blobs.gamma[i])};
  return sum;
}

Blobs take_outside(Blobs& blobs, const Box& box) {
  return take_but(blobs, [&](std::size_t i) { return box.holds(blobs.centre(i)); });
}

Outflow remove_faint(Blobs& blobs, double faintest) {
  return account_of(
      take_but(blobs, [&](std::size_t i) { return std::abs(blobs.gamma[i]) > faintest; }));
}

}  // namespace vortree::vortex
