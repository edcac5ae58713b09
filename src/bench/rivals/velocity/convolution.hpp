#pragma once

#include <fftw3.h>

#include <memory>
#include <span>
#include <vector>

#include "bench/rivals/velocity/vortex_spectrum.hpp"
#include "tree/base/memory.hpp"

namespace vortree::bench {

/// Velocities on a grid from vortices on the same grid, by Fourier transforms with so much empty
/// room around that copies are not felt.
///
///   (u, v)(m) = sum_n K(m - n) gamma(n),  hat K(xi) = (i xi_y, -i xi_x) hat psi(xi) f(xi_x)
///   f(xi_y)
///
/// lengths in grid spacings, hat psi as VortexSpectrum, f a factor of each direction.
///
/// nx, ny   grid lines in use; px, py   of the period, even, nx <= px, ny <= py
/// cost     one transform forth and two back, of 1-D transforms only those that see values: rows in
///          use, all columns. 16 ny px bytes beside the values
/// threads  OpenMP; same bits for any number
/// source   Hockney & Eastwood 1988; Vico, Greengard & Ferrando, J. Comput. Phys. 323 (2016)
class Convolution {
 public:
  struct Size {
    int nx, ny, px, py;
  };
  struct Factors {
    std::vector<double> x, y;  // px/2 + 1 and py/2 + 1 values, at 2 pi q/p
  };

  /// measured   FFTW times which transforms are fastest, up to half a second for each direction of
  /// a
  ///            size, once in a process; else it guesses
  Convolution(const Size& size, bool measured);

  /// gamma, u, v   ny rows of `stride` values; u may be gamma
  void velocity(const VortexSpectrum& vortex, const Factors& factors, std::size_t stride,
                std::span<const double> gamma, std::span<double> u, std::span<double> v);

 private:
  struct Destroy {
    void operator()(fftw_plan_s* plan) const { fftw_destroy_plan(plan); }
  };
  using Transform = std::unique_ptr<fftw_plan_s, Destroy>;

  void transform_rows(std::size_t stride, std::span<const double> gamma);
  void filter_columns(const VortexSpectrum& vortex, const Factors& factors);
  void restore_rows(Reals& spectrum, std::size_t stride, std::span<double> values);
  void filter_column(int column, const VortexSpectrum& vortex, const Factors& factors,
                     double* along_x, double* along_y) const;

  Size size_;
  std::size_t row_;  // doubles of a row of a spectrum
  Reals spectrum_, other_;
  Transform row_forth_, row_back_, column_forth_, column_back_;
};

/// The least even number >= n that has no prime factor above 7.
int smooth_length(int n);

}  // namespace vortree::bench
