#pragma once

#include <complex>
#include <cstddef>
#include <span>

namespace vortree::fmm {

/// Multipole operators of the logarithmic kernel, said plainly; the kernels are tested against
/// them.
///
/// With a centre z0 and a length h that no source exceeds, t = (z - z0)/h:
///   multipole   c_k = sum_j gamma_j t_j^k,  k = 0 .. order-1      |c_k| <= sum |gamma_j|
///   far field   f(z) = sum_j gamma_j / (z - z_j) = (1/h) sum_k c_k w^(k+1),  w = h/(z - z0)
///   local expansion   f(z) = (1/h) sum_l L_l t^l, nearer to z0 than any source
///   velocity    u - i v = f / (2 pi i)
/// Scaled by h, coefficients neither over- nor underflow, at any depth and order.
///
/// error   of `order` terms: (sum |gamma_j| / |z - z0|) |w|^order / (1 - |w|)
/// source  Carrier, Greengard & Rokhlin 1988; Huang, Huang, Xu & Hu 2012, eq. 4-5
using Complex = std::complex<double>;

/// Adds sources at z to the multipole about centre.
inline void p2m(std::span<const Complex> z, std::span<const double> gamma, Complex centre, double h,
                std::span<Complex> multipole) {
  for (std::size_t j = 0; j < z.size(); ++j) {
    const Complex t = (z[j] - centre) / h;
    Complex power = gamma[j];
    for (Complex& c : multipole) {
      c += power;
      power *= t;
    }
  }
}

/// Adds a child's multipole to its parent's, d = (z_child - z_parent)/h_parent,
/// s = h_child/h_parent:
///
///   C_k += sum_{j <= k} binom(k, j) d^(k-j) s^j c_j
///
/// which is eq. 5 of the paper, its missing sum over the children restored: m_k^k = 1,
/// m_{j-1}^k = m_j^k d (j-1)/(k-j+1), counted there from one.
inline void m2m(std::span<const Complex> child, Complex d, double s, std::span<Complex> parent) {
  for (std::size_t k = 0; k < parent.size(); ++k) {
    Complex m = 1.0;
    for (std::size_t j = k;; --j) {
      parent[k] += m * std::pow(s, static_cast<double>(j)) * child[j];
      if (j == 0) break;
      m *= d * (static_cast<double>(j) / static_cast<double>(k - j + 1));
    }
  }
}

/// The far field f at z.
inline Complex m2p(std::span<const Complex> multipole, Complex centre, double h, Complex z) {
  const Complex w = h / (z - centre);
  Complex f = 0.0;
  for (std::size_t k = multipole.size(); k-- > 0;) f = f * w + multipole[k];
  return f * w / h;
}

/// Adds sources at z to the local expansion about centre: L_l -= sum_j gamma_j t_j^-(l+1).
inline void p2l(std::span<const Complex> z, std::span<const double> gamma, Complex centre, double h,
                std::span<Complex> local) {
  for (std::size_t j = 0; j < z.size(); ++j) {
    const Complex w = h / (z[j] - centre);
    Complex power = -gamma[j] * w;
    for (Complex& term : local) {
      term += power;
      power *= w;
    }
  }
}

/// Adds a multipole to a local expansion of the same h, D = (z_local - z_multipole)/h:
///
///   L_l += (-1)^l sum_k binom(k+l, l) c_k D^-(k+l+1)
///
/// from 1/(D + t)^(k+1) = sum_l binom(k+l, l) (-t)^l D^-(k+l+1).
inline void m2l(std::span<const Complex> multipole, Complex d, std::span<Complex> local) {
  Complex first = 1.0 / d;  // (-1)^l D^-(l+1)
  for (std::size_t l = 0; l < local.size(); ++l, first /= -d) {
    Complex m = first;
    for (std::size_t k = 0; k < multipole.size(); ++k) {
      local[l] += m * multipole[k];
      m *= static_cast<double>(k + l + 1) / static_cast<double>(k + 1) / d;
    }
  }
}

/// Adds a parent's local expansion to its child's, d = (z_child - z_parent)/h_parent,
/// s = h_child/h_parent:
///
///   l_m += s^(m+1) sum_{l >= m} binom(l, m) d^(l-m) L_l
inline void l2l(std::span<const Complex> parent, Complex d, double s, std::span<Complex> child) {
  for (std::size_t m = 0; m < child.size(); ++m) {
    Complex power = std::pow(s, static_cast<double>(m + 1));
    for (std::size_t l = m; l < parent.size(); ++l) {
      child[m] += power * parent[l];
      power *= d * (static_cast<double>(l + 1) / static_cast<double>(l + 1 - m));
    }
  }
}

/// The field f at z.
inline Complex l2p(std::span<const Complex> local, Complex centre, double h, Complex z) {
  const Complex t = (z - centre) / h;
  Complex f = 0.0;
  for (std::size_t l = local.size(); l-- > 0;) f = f * t + local[l];
  return f / h;
}

}  // namespace vortree::fmm
