#include "vortex/retire.hpp"

#include <algorithm>

namespace vortree::vortex {
namespace {

struct Gone {
  double gamma = 0, sigma = 0;
  Vec2 moment;
  int count = 0;
};

}  // namespace

void retire(Blobs& blobs, const Box& box) {
  Gone gone[2];
  std::size_t left = 0;
  for (std::size_t i = 0; i < blobs.size(); ++i) {
    const Vec2 at = blobs.centre(i);
    const double gamma = blobs.gamma[i];
    if (box.holds(at) || gamma == 0) {
      blobs.put(left++, at, gamma, blobs.sigma[i]);
      continue;
    }
    Gone& sign = gone[gamma < 0];
    sign.gamma += gamma;
    sign.moment = sign.moment + gamma * at;
    sign.sigma = std::max(sign.sigma, blobs.sigma[i]);
    ++sign.count;
  }
  blobs.resize(left);
  for (const Gone& sign : gone)
    if (sign.count > 0) blobs.append((1 / sign.gamma) * sign.moment, sign.gamma, sign.sigma);
}

}  // namespace vortree::vortex
