#pragma once

#include <cmath>

#include "tree/base/simd.hpp"

namespace vortree::bench {

/// Numbers of twice the digits of a double, high + low, eight at a time.
///
/// Sums and products are exact to 2^-100 or so; the compiler must keep the order of operations.
/// source  Dekker, Numer. Math. 18 (1971)
struct Twice {
  Lanes high, low;
};

inline Lanes fused(Lanes a, Lanes b, Lanes c) {
  Lanes result;
  for (int i = 0; i < lane_count; ++i) result[i] = std::fma(a[i], b[i], c[i]);
  return result;
}

inline Twice exact_sum(Lanes a, Lanes b) {
  const Lanes sum = a + b, part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

inline Twice exact_product(Lanes a, Lanes b) {
  const Lanes product = a * b;
  return {product, fused(a, b, -product)};
}

inline Twice renormalised(Lanes high, Lanes low) {
  const Lanes sum = high + low;
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
  const Lanes first = 1.0 / a.high;
  const Lanes missed = fused(-first, a.high, fill(1.0)) - first * a.low;
  return renormalised(first, first * missed);
}

}  // namespace vortree::bench
