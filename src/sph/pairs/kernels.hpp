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
///   kernel          support  norm(2)            p    shape
///   wendland_c2     2        7/(4 pi)           5    (1 - q/2)^4 (2 q + 1)
///                                                    (1 - q/2)^3 (1.5 q + 1) in d = 1
///   wendland_c4     2        9/(4 pi)           7    (1 - q/2)^6 (35/12 q^2 + 3 q + 1)
///                                                    (1 - q/2)^5 (2 q^2 + 2.5 q + 1) in d = 1
///   wendland_c6     2        78/(28 pi)         9    (1 - q/2)^8 (4 q^3 + 6.25 q^2 + 4 q + 1)
///                                                    (1 - q/2)^7 (21/8 q^3 + 19/4 q^2 + 3.5 q + 1)
///                                                    in d = 1
///   cubic_spline    2        5/(14 pi)          4.5  (2 - q)^3 - 4 (1 - q)^3
///   quintic_spline  3        7/(478 pi)         6.5  (3 - q)^5 - 6 (2 - q)^5 + 15 (1 - q)^5
///   gaussian        3        1/(pi (1 - e^-9))  1.5  exp(-q^2), cut off: norm counts what is left
///   quadratic       2        3/(2 pi)           3    (q/2)^2 - q + 1
///   bell            1        5/pi               4.5  (1 + 3 q) (1 - q)^3, Lucy's
///
/// powers of negative numbers counting as zero in the splines. tests/sph/pairs/kernels.cpp has norm
/// by quadrature.
///
/// On a plane lattice of spacing dx the sum of dx^2 W differs from one by O((dx/h)^p): by the
/// kernel's Fourier transform at the waves of the lattice, which falls with how smooth the kernel
/// is. Where it goes as r^n at the middle, n odd, and as (s - r)^m at radii s, p is the least of
/// n + 2 and m + 3/2 (tests/sph/lattice.cpp).
///
/// source  Wendland's: Adv. Comput. Math. 4 (1995), for d = 1, 2, 3 as in table 1 of Dehnen & Aly,
///         MNRAS 425 (2012); that has the splines, too, for SPH of Monaghan & Lattanzio, Astron.
///         Astrophys. 149 (1985)
///         gaussian: Gingold & Monaghan, MNRAS 181 (1977)
///         quadratic: Johnson, Stryk & Beissel, Comput. Methods Appl. Mech. Eng. 139 (1996)
///         bell: Lucy, Astron. J. 82 (1977)
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

/// W and dW/dr for q >= 0, h = 1, without norm: to be scaled as above. At q = 0 the slope is 0, of
/// quadratic's cusp, too.
[[nodiscard]] double shape(Kernel kernel, int dimensions, double q);
[[nodiscard]] double slope(Kernel kernel, int dimensions, double q);

/// W(r, h) [1/m^d] and dW/dr [1/m^(d+1)]; r >= 0, h > 0.
[[nodiscard]] double value(Kernel kernel, int dimensions, double r, double h);
[[nodiscard]] double derivative(Kernel kernel, int dimensions, double r, double h);

}  // namespace vortree::sph
