#include "vortex/invariants.hpp"

#include <cmath>

namespace vortree::vortex {
namespace {

class Sum {
 public:
  void operator+=(double a) {
    const double next = total_ + a;
    lost_ += std::abs(total_) >= std::abs(a) ? (total_ - next) + a : (a - next) + total_;
    total_ = next;
  }
  double value() const { return total_ + lost_; }

 private:
  double total_ = 0, lost_ = 0;
};

}  // namespace

Invariants invariants(const Blobs& blobs, const Shape* wall) {
  const Acting at = acting(blobs, wall);
  Sum circulation, x, y, second;
  for (std::size_t i = 0; i < blobs.size(); ++i) {
    const double g = blobs.gamma[i], s = blobs.sigma[i];
    circulation += g;
    x += g * at.x[i];
    y += g * at.y[i];
    second += g * (dot(at.at(i), at.at(i)) + s * s);
  }
  return {circulation.value(), {x.value(), y.value()}, second.value()};
}

}  // namespace vortree::vortex
