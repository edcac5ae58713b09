#include <complex>

#include "fmm/series/translation_kernel.hpp"

namespace vortree::fmm {
namespace {

template <class Number>
typename TranslationTables<Number>::Power narrow(std::complex<double> value) {
  return {static_cast<Number>(value.real()), static_cast<Number>(value.imag())};
}

}  // namespace

template <class Number>
TranslationTables<Number>::TranslationTables(int most, const std::array<int, orbit_count>& terms)
    : order(most),
      pascal(static_cast<std::size_t>(most * most)),
      lower(pascal.size()),
      upper(pascal.size()) {
  std::vector<double> binomial(pascal.size());
  for (int l = 0; l < most; ++l) {
    for (int k = 0; k < most; ++k) {
      double& b = binomial[l * most + k];
      b = l == 0 || k == 0 ? 1.0 : binomial[(l - 1) * most + k] + binomial[l * most + k - 1];
      pascal[l * most + k] = static_cast<Number>(b);
      if (l + k >= most) continue;
      lower[(l + k) * most + k] = static_cast<Number>(b);
      upper[k * most + l + k] = static_cast<Number>(b / 2);
    }
  }
  for (int o = 0; o < orbit_count; ++o) {
    const std::complex inverse = 1.0 / std::complex<double>(orbits[o].x, orbits[o].y);
    orbit[o].terms = terms[o];
    for (auto* powers : {&orbit[o].in, &orbit[o].out})
      powers->reserve(static_cast<std::size_t>(terms[o]));
    std::complex<double> in = inverse, out = 1.0;
    for (int k = 0; k < terms[o]; ++k, in *= inverse, out *= -inverse) {
      orbit[o].in.push_back(narrow<Number>(in));
      orbit[o].out.push_back(narrow<Number>(out));
    }
  }
  for (int q = 0; q < 4; ++q) {
    const std::complex<double> d((q % 2 - 0.5) / 2, (q / 2 - 0.5) / 2);
    for (auto* powers : {&child[q].up, &child[q].down})
      powers->reserve(static_cast<std::size_t>(most));
    std::complex<double> up = 1.0, down = 1.0;
    for (int k = 0; k < most; ++k, up *= d, down /= 2.0 * d) {
      child[q].up.push_back(narrow<Number>(up));
      child[q].down.push_back(narrow<Number>(down));
    }
  }
}

template struct TranslationTables<double>;
template struct TranslationTables<float>;

}  // namespace vortree::fmm
