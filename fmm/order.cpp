#include "fmm/order.hpp"

#include <algorithm>
#include <cmath>

namespace vortree::fmm {

int terms_for(double tolerance, double ratio) {
  if (ratio <= 0.0) return 1;
  const double allowed = std::min(overestimate * tolerance, 0.5) * (1.0 - ratio);
  return std::max(1, static_cast<int>(std::ceil(std::log(allowed) / std::log(ratio))));
}

Order Order::for_tolerance(double tolerance) {
  Order order;
  order.squared_ratio_ = widest_ratio * widest_ratio;
  order.per_bin_ = bins / order.squared_ratio_;
  for (int bin = 0; bin <= bins; ++bin) {
    const double largest = std::sqrt(std::min(bin + 1, bins) / order.per_bin_);
    order.terms_[bin] = terms_for(tolerance, largest);
  }
  order.most_ = order.terms_[bins];
  return order;
}

Order Order::fixed(int terms) {
  Order order;
  order.squared_ratio_ = one_cell_apart * one_cell_apart;
  order.per_bin_ = bins / order.squared_ratio_;
  order.terms_.fill(terms);
  order.most_ = terms;
  return order;
}

}  // namespace vortree::fmm
