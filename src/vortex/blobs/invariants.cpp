#include "vortex/blobs/invariants.hpp"

#include <cmath>

#include "base/ordered_sum.hpp"

namespace vortree::vortex {
namespace {

class CompensatedSum {
 public:
  void operator+=(const CompensatedSum& other) {
    *this += other.total_;
    lost_ += other.lost_;
  }
  void operator+=(double a) {
    const double next = total_ + a;
    lost_ += std::abs(total_) >= std::abs(a) ? (total_ - next) + a : (a - next) + total_;
    total_ = next;
  }
  double value() const { return total_ + lost_; }

 private:
  double total_ = 0, lost_ = 0;
};

struct InvariantSums {
  CompensatedSum circulation, x, y, second;

  void operator+=(const InvariantSums& other) {
    circulation += other.circulation;
    x += other.x;
    y += other.y;
    second += other.second;
  }
};

}  // namespace

Invariants invariants(const Blobs& blobs, const FoldedBlobs& at) {
  const InvariantSums all = ordered_sum(blobs.size(), [&](std::size_t first, std::size_t last) {
    InvariantSums sums;
    for (std::size_t i = first; i < last; ++i) {
      const double g = blobs.gamma[i], s = blobs.sigma[i];
      sums.circulation += g;
      sums.x += g * at.x[i];
      sums.y += g * at.y[i];
      sums.second += g * (dot(at.at(i), at.at(i)) + s * s);
    }
    return sums;
  });
  return {all.circulation.value(), {all.x.value(), all.y.value()}, all.second.value()};
}

Invariants invariants(const Blobs& blobs, const body::Shape* wall) {
  return invariants(blobs, fold(blobs, wall));
}

}  // namespace vortree::vortex
