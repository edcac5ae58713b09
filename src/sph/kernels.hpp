#pragma once

#include <array>
#include <string_view>

namespace vortree::sph {

/// The smoothing kernels of SPH, as functions of q = r / h.
///
///   W(r, h) = norm(d) / h^d  shape(q),     dW/dr = norm(d) / h^(d+1)  slope(q),     r < support h
///
/// and zero beyond. norm(d) makes the integral of W over d = 1, 2 or 3 dimensions one.
///
///   kernel           support   shape
///   wendland_c2      2         (1 - q/2)^4 (2 q + 1)                               d = 2, 3
///                              (1 - q/2)^3 (1.5 q + 1)                             d = 1
///   wendland_c4      2         (1 - q/2)^6 (35/12 q^2 + 3 q + 1)                   d = 2, 3
///                              (1 - q/2)^5 (2 q^2 + 2.5 q + 1)                     d = 1
///   wendland_c6      2         (1 - q/2)^8 (4 q^3 + 6.25 q^2 + 4 q + 1)            d = 2, 3
///                              (1 - q/2)^7 (21/8 q^3 + 19/4 q^2 + 3.5 q + 1)       d = 1
///   cubic_spline     2         (2 - q)^3 - 4 (1 - q)^3
///   quintic_spline   3         (3 - q)^5 - 6 (2 - q)^5 + 15 (1 - q)^5
///   gaussian         3         exp(-q^2), cut off: norm counts what is left
///   quadratic        2         (q/2)^2 - q + 1
///   bell             1         (1 + 3 q) (1 - q)^3, Lucy's
///
/// powers of negative numbers counting as zero in the splines.
///
/// source  Wendland 1995; Dehnen & Aly, MNRAS 425 (2012); Monaghan, Annu. Rev. 30 (1992); Liu & Liu
///         2003; Lucy, Astron. J. 82 (1977)
enum class Kernel {
  wendland_c2,
  wendland_c4,
  wendland_c6,
  cubic_spline,
  quintic_spline,
  gaussian,
  quadratic,
  bell
};

inline constexpr std::array every_kernel{
    Kernel::wendland_c2,    Kernel::wendland_c4, Kernel::wendland_c6, Kernel::cubic_spline,
    Kernel::quintic_spline, Kernel::gaussian,    Kernel::quadratic,   Kernel::bell};

[[nodiscard]] std::string_view name_of(Kernel kernel);

/// The q beyond which a kernel is zero.
[[nodiscard]] double support(Kernel kernel);

/// dimensions  1, 2 or 3
/// throws      std::invalid_argument for any other number
[[nodiscard]] double norm(Kernel kernel, int dimensions);

/// W and dW/dr for q >= 0, h = 1, without norm: to be scaled as above.
[[nodiscard]] double shape(Kernel kernel, int dimensions, double q);
[[nodiscard]] double slope(Kernel kernel, int dimensions, double q);

/// W(r, h) [1/m^d] and dW/dr [1/m^(d+1)]; r >= 0, h > 0.
[[nodiscard]] double value(Kernel kernel, int dimensions, double r, double h);
[[nodiscard]] double derivative(Kernel kernel, int dimensions, double r, double h);

}  // namespace vortree::sph
