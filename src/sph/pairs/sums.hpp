#pragma once

#include <span>

#include "sph/pairs/kernels.hpp"
#include "tree/neighbors/neighbors.hpp"

namespace vortree::sph {

/// Particles that sums run over: n of each, and the kernel that smooths them.
///
/// reach   radius of the support [m]: support(kernel) h
struct SmoothedParticles {
  tree::Points points;
  std::span<const double> mass, reach;
  Kernel kernel = Kernel::wendland_c6;
};

/// Density by summation, in the plane:
///
///   rho_i = m_i W(0, h_i) + sum_j m_j W(|x_i - x_j|, (h_i + h_j) / 2)
///
/// so that the neighbors are those of PairRule::mean, and i gives j what j gives i.
///
/// rho     n densities [kg/m^2]; overwritten
/// error   of a smooth density on a lattice of spacing dx, O(h^2) + O((dx/h)^p), p of the kernel
///         (kernels.hpp; tests/sph/lattice.cpp)
/// cost    one kernel a pair: O(n)
/// source  Monaghan, Annu. Rev. Astron. Astrophys. 30 (1992); Hernquist & Katz, Astrophys. J.
///         Suppl. 70 (1989), for the mean h
///
/// rows          by rule mean; both ways, rows shared by threads, or each pair once, one thread
/// search        already placed; nothing is stored
void density(const SmoothedParticles& particles, const tree::PairList& rows, tree::Listing listing,
             std::span<double> rho);
void density(const SmoothedParticles& particles, tree::Neighbors& search, std::span<double> rho);

/// Gradient of a field, in the form that is exact for constants:
///
///   (grad f)_i = sum_j m_j / rho_j (f_j - f_i) grad_i W(|x_i - x_j|, (h_i + h_j) / 2)
///
/// and what coincides with i gives nothing.
///
/// volume   m_j / rho_j [m^2]
/// gx, gy   n each; overwritten
/// error    as that of the density, but with the least of n + 2 and m + 1/2 for p. By gaussian, of
///          whose edge the slope knows nothing, all is 9/(e^9 - 1) = 0.11 % too small
void gradient(const SmoothedParticles& particles, std::span<const double> volume,
              std::span<const double> f, const tree::PairList& rows, tree::Listing listing,
              std::span<double> gx, std::span<double> gy);
void gradient(const SmoothedParticles& particles, std::span<const double> volume,
              std::span<const double> f, tree::Neighbors& search, std::span<double> gx,
              std::span<double> gy);

}  // namespace vortree::sph
