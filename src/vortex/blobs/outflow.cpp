#include "vortex/blobs/outflow.hpp"

#include <cmath>

#include "tree/base/numbers_where.hpp"

namespace vortree::vortex {

namespace {

/// Takes away the blobs that `goes(i)` names, and hands them out.
Blobs take_those(Blobs& blobs, auto goes) {
  const std::vector<std::uint32_t> numbers = tree::numbers_where(blobs.size(), goes);
  Blobs gone;
  for (const std::uint32_t i : numbers) gone.append(blobs.centre(i), blobs.gamma[i], blobs.core(i));
  blobs.erase(numbers);
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
  return take_those(blobs, [&](std::size_t i) { return !box.holds(blobs.centre(i)); });
}

Outflow remove_faint(Blobs& blobs, double faintest) {
  return account_of(
      take_those(blobs, [&](std::size_t i) { return !(std::abs(blobs.gamma[i]) > faintest); }));
}

}  // namespace vortree::vortex
