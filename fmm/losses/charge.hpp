#pragma once

#include <algorithm>
#include <cstddef>

namespace vortree::fmm {

/// What a cell holds, as the errors see it that it causes elsewhere, in Units.
///
/// squares     sum gamma_j^2: what rounding errors add up to, random among each other
/// effective   max_k |c_k|^2 / <|t|^(2k)> over the terms of its multipole: the sum gamma_j^2 of
///             random circulations, evenly spread, that would leave out as much. Less where the
///             circulations of a cell cancel, more where they sit in its corners or have one sign
struct Charge {
  double effective = 0.0, squares = 0.0;
};

/// weights   of the terms: 1/<|t|^(2k)>
template <class Number>
[[nodiscard]] double effective_charge(const Number* re, const Number* im, const Number* weights,
                                      std::size_t terms) {
  Number most = 0;
#pragma omp simd reduction(max : most)
  for (std::size_t k = 0; k < terms; ++k) {
    most = std::max(most, (re[k] * re[k] + im[k] * im[k]) * weights[k]);
  }
  return static_cast<double>(most);
}

}  // namespace vortree::fmm
