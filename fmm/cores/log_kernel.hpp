#pragma once

#include <bit>
#include <cstdint>
#include <numbers>

#include "tree/base/simd.hpp"

namespace vortree::fmm {

/// ln x of positive normal numbers. With x = 2^e m, 1/sqrt 2 <= m < sqrt 2, and s = (m - 1)/(m +
/// 1),
///
///   ln x = e ln 2 + 2 s (1 + s^2/3 + s^4/5 + ...),   s^2 < 0.0295: eleven terms
///
/// error   3e-16 of |ln x|, and of nothing more near x = 1
/// twin    std::log
inline Lanes logarithm(Lanes x) {
  constexpr auto half_root = std::bit_cast<std::int64_t>(0.5 * std::numbers::sqrt2);
  constexpr auto shifter = std::bit_cast<std::int64_t>(0x1.8p52);
  const Bits exponent = ((Bits)x - half_root) >> 52;
  const Lanes m = (Lanes)((Bits)x - (exponent << 52));
  const Lanes e = (Lanes)(exponent + shifter) - 0x1.8p52;
  const Lanes s = (m - 1.0) / (m + 1.0), s2 = s * s;
  Lanes series = fill(1.0 / 21);
  for (int k = 19; k >= 3; k -= 2) series = series * s2 + 1.0 / k;
  return e * std::numbers::ln2 + (2.0 * s + (2.0 * s) * (s2 * series));
}

}  // namespace vortree::fmm
