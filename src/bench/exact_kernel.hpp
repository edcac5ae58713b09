#pragma once

#include <cmath>

#include "fmm/lanes.hpp"

namespace vortree::bench {

/// Numbers of twice the digits of a double, high + low, eight at a time.
///
/// Sums and products are exact to 2^-100 or so; the compiler must keep the order of operations.
/// source  Dekker, Numer. Math. 18 (1971)
struct Twice {
  fmm::Lanes high, low;
};

inline fmm::Lanes fused(fmm::Lanes a, fmm::Lanes b, fmm::Lanes c) {
  fmm::Lanes result;
  for (int i = 0; i < fmm::lane_count; ++i) result[i] = std::fma(a[i], b[i], c[i]);
  return result;
}

inline Twice exact_sum(fmm::Lanes a, fmm::Lanes b) {
  const fmm::Lanes sum = a + b, part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

inline Twice exact_product(fmm::Lanes a, fmm::Lanes b) {
  const fmm::Lanes product = a * b;
  return {product, fused(a, b, -product)};
}

inline Twice renormalised(fmm::Lanes high, fmm::Lanes low) {
  const fmm::Lanes sum = high + low;
  return {sum, low - (sum - high)};
}

inline Twice operator+(const Twice& a, const Twice& b) {
  const Twice sum = exact_sum(a.high, b.high);
  return renormalised(sum.high, sum.low + (a.low + b.low));
}

inline Twice operator*(const Twice& a, const Twice& b) {
  const Twice product = exact_product(a.high, b.high);
  return renormalised(product.high, product.low + (a.high * b.low + a.low * b.high));
}

inline Twice inverse(const Twice& a) {
  const fmm::Lanes first = 1.0 / a.high;
  const fmm::Lanes missed = fused(-first, a.high, fmm::fill(1.0)) - first * a.low;
  return renormalised(first, first * missed);
}

}  // namespace vortree::bench
