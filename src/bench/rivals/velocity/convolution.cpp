#include "bench/rivals/velocity/convolution.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vortree::bench {
namespace {

constexpr double longest_planning = 0.25;  // seconds a transform
constexpr int columns_at_once = 8;         // complex numbers that are read from a row together

fftw_complex* complex(double* values) {
  return reinterpret_cast<fftw_complex*>(values);
}

// Room for the columns in work, and for their second copy.
std::size_t column_length(int py) {
  return 2 * (static_cast<std::size_t>(py) + 4) / 8 * 8;
}

}  // namespace

int smooth_length(int n) {
  for (n += n % 2;; n += 2) {
    int rest = n;
    for (const int prime : {2, 3, 5, 7})
      while (rest % prime == 0) rest /= prime;
    if (rest == 1) return n;
  }
}

Convolution::Convolution(const Size& size, bool measured)
    : size_(size), row_((static_cast<std::size_t>(size.px) + 2 + 7) / 8 * 8) {
  const unsigned care = measured ? FFTW_MEASURE : FFTW_ESTIMATE;
  fftw_set_timelimit(longest_planning);
  Reals values(size.px + 2), row(row_), column(column_length(size.py));
  fftw_complex *along_row = complex(row.data()), *along = complex(column.data());
  row_forth_.reset(fftw_plan_dft_r2c_1d(size.px, values.data(), along_row, care));
  row_back_.reset(fftw_plan_dft_c2r_1d(size.px, along_row, values.data(), care));
  column_forth_.reset(fftw_plan_dft_1d(size.py, along, along, FFTW_FORWARD, care));
  column_back_.reset(fftw_plan_dft_1d(size.py, along, along, FFTW_BACKWARD, care));
  spectrum_.resize(row_ * size.ny);
  other_.resize(row_ * size.ny);
}

void Convolution::velocity(const VortexSpectrum& vortex, const Factors& factors, std::size_t stride,
                           std::span<const double> gamma, std::span<double> u,
                           std::span<double> v) {
  transform_rows(stride, gamma);
  filter_columns(vortex, factors);
  restore_rows(spectrum_, stride, u);
  restore_rows(other_, stride, v);
}

void Convolution::transform_rows(std::size_t stride, std::span<const double> gamma) {
#pragma omp parallel
  {
    Reals values(size_.px + 2);
    std::ranges::fill(values, 0.0);
#pragma omp for schedule(static)
    for (int m = 0; m < size_.ny; ++m) {
      std::copy_n(&gamma[m * stride], size_.nx, values.data());
      fftw_execute_dft_r2c(row_forth_.get(), values.data(), complex(&spectrum_[m * row_]));
    }
  }
}

void Convolution::restore_rows(Reals& spectrum, std::size_t stride, std::span<double> values) {
#pragma omp parallel
  {
    Reals row(size_.px + 2);
#pragma omp for schedule(static)
    for (int m = 0; m < size_.ny; ++m) {
      fftw_execute_dft_c2r(row_back_.get(), complex(&spectrum[m * row_]), row.data());
      std::copy_n(row.data(), size_.nx, &values[m * stride]);
    }
  }
}

void Convolution::filter_columns(const VortexSpectrum& vortex, const Factors& factors) {
  const int columns = size_.px / 2 + 1;
  const std::size_t length = column_length(size_.py);
#pragma omp parallel
  {
    Reals along_x(columns_at_once * length), along_y(columns_at_once * length);
#pragma omp for schedule(static)
    for (int first = 0; first < columns; first += columns_at_once) {
      const int some = std::min(columns_at_once, columns - first);
      std::ranges::fill(along_x, 0.0);
      for (int m = 0; m < size_.ny; ++m)
        for (int c = 0; c < some; ++c)
          std::copy_n(&spectrum_[m * row_ + 2 * (first + c)], 2, &along_x[c * length + 2 * m]);
      for (int c = 0; c < some; ++c)
        filter_column(first + c, vortex, factors, &along_x[c * length], &along_y[c * length]);
      for (int m = 0; m < size_.ny; ++m)
        for (int c = 0; c < some; ++c) {
          std::copy_n(&along_x[c * length + 2 * m], 2, &spectrum_[m * row_ + 2 * (first + c)]);
          std::copy_n(&along_y[c * length + 2 * m], 2, &other_[m * row_ + 2 * (first + c)]);
        }
    }
  }
}

// The velocity along x replaces the strengths. At the ends of the spectrum, pi, a derivative of
// real values has no place: it is taken as zero.
void Convolution::filter_column(int column, const VortexSpectrum& vortex, const Factors& factors,
                                double* along_x, double* along_y) const {
  const int half = size_.py / 2;
  const double turn = 2.0 * std::numbers::pi;
  const double xi = turn * column / size_.px, slope = 2 * column == size_.px ? 0.0 : xi;
  const double common = factors.x[column] / (static_cast<double>(size_.px) * size_.py);
  fftw_execute_dft(column_forth_.get(), complex(along_x), complex(along_x));
  const auto turn_into_velocity = [&](int q, double eta, double weight) {
    const double re = along_x[2 * q] * weight, im = along_x[2 * q + 1] * weight;
    along_x[2 * q] = -eta * im;
    along_x[2 * q + 1] = eta * re;
    along_y[2 * q] = slope * im;
    along_y[2 * q + 1] = -slope * re;
  };
  for (int q = 0; q <= half; ++q) {
    const double eta = turn * q / size_.py, k2 = xi * xi + eta * eta;
    const double weight = k2 > 0.0 ? common * factors.y[q] * vortex.felt(std::sqrt(k2)) / k2 : 0.0;
    turn_into_velocity(q, q == half ? 0.0 : eta, weight);
    if (q > 0 && q < half) turn_into_velocity(size_.py - q, -eta, weight);
  }
  fftw_execute_dft(column_back_.get(), complex(along_x), complex(along_x));
  fftw_execute_dft(column_back_.get(), complex(along_y), complex(along_y));
}

}  // namespace vortree::bench
