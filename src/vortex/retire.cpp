#include "vortex/retire.hpp"

namespace vortree::vortex {

Retired retire(Blobs& blobs, const Box& box) {
  Retired gone;
  std::size_t left = 0;
  for (std::size_t i = 0; i < blobs.size(); ++i) {
    const Vec2 at = blobs.centre(i);
    if (box.holds(at))
      blobs.put(left++, at, blobs.gamma[i], blobs.sigma[i]);
    else
      gone = gone + Retired{blobs.gamma[i], blobs.gamma[i] * at};
  }
  blobs.resize(left);
  return gone;
}

}  // namespace vortree::vortex
