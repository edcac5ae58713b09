#include "fmm/series/order.hpp"

#include <algorithm>
#include <cmath>

namespace vortree::fmm {

int terms_for(double tolerance, double ratio) {
  double rest = 1.0 / (1.0 - ratio);
  int terms = 0;
  do {
    rest *= ratio;
    ++terms;
  } while (rest > std::sqrt(terms + 1.0) * tolerance);
  return terms;
}

double slope_ratio(double tolerance, int terms) {
  const double bound = tolerance / std::sqrt(terms + 1.0);
  double low = 0.0, high = widest_ratio;
  for (int step = 0; step < 50; ++step) {
    const double ratio = 0.5 * (low + high), rest = 1.0 - ratio;
    (std::pow(ratio, terms) <= bound * rest * rest ? low : high) = ratio;
  }
  return low;
}

SeriesOrder SeriesOrder::for_tolerance(double tolerance) {
  SeriesOrder order;
  order.squared_ratio_ = widest_ratio * widest_ratio;
  order.per_bin_ = bins / order.squared_ratio_;
  for (int bin = 0; bin <= bins; ++bin) {
    const double largest = std::sqrt(std::min(bin + 1, bins) / order.per_bin_);
    order.terms_[bin] = terms_for(tolerance, largest);
  }
  order.most_ = order.terms_[bins];
  return order;
}

SeriesOrder SeriesOrder::fixed(int terms, double ratio) {
  SeriesOrder order;
  order.squared_ratio_ = ratio * ratio;
  order.per_bin_ = bins / order.squared_ratio_;
  order.terms_.fill(terms);
  order.most_ = terms;
  return order;
}

}  // namespace vortree::fmm
