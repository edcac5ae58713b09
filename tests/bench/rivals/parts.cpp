#include <math.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "bench/rivals/velocity/convolution.hpp"
#include "bench/rivals/velocity/vortex_spectrum.hpp"
#include "bench/rivals/velocity/window.hpp"

using namespace vortree;
using bench::Window;

namespace {

double window_plain(double x, double width, double shape) {
  const double q = 1.0 - 4.0 * x * x / (width * width);
  return q < 0.0 ? 0.0
                 : std::cyl_bessel_i(0.0, shape * std::sqrt(q)) / std::cyl_bessel_i(0.0, shape);
}

constexpr int whole(int width) {
  return (width + Window::lanes - 1) / Window::lanes;
}

template <int vectors>
double worst_weight(int width, double shape) {
  const Window window(width, shape, 1e-15);
  REQUIRE(window.vectors() == vectors);
  double worst = 0.0;
  for (double t = 0.0; t <= 1.0; t += 1.0 / 64) {
    Lanes weights[vectors];
    window.weigh<vectors>(t, weights);
    for (int j = 0; j < vectors * Window::lanes; ++j) {
      const double expected = j < width ? window_plain(j + t - 0.5 * width, width, shape) : 0.0;
      worst = std::max(worst, std::abs(weights[j / Window::lanes][j % Window::lanes] - expected));
    }
  }
  return worst;
}

}  // namespace

TEST_CASE("a window's polynomials are the Kaiser-Bessel formula to round-off") {
  CHECK(worst_weight<whole(2)>(2, 3.0) < 2e-14);
  CHECK(worst_weight<whole(8)>(8, 16.0) < 2e-14);
  CHECK(worst_weight<whole(9)>(9, 20.0) < 2e-14);
  CHECK(worst_weight<whole(16)>(16, 33.0) < 2e-14);
}

TEST_CASE("a window's transform is the integral of the window") {
  const double width = 7.0, shape = 14.0;
  const Window window(7, shape, 1e-15);
  for (const double xi : {0.0, 0.4, 1.0, 2.0, 3.1}) {
    // The trapezoidal rule in x = sin(angle) width/2, smooth to the ends.
    double sum = 0.0;
    constexpr int n = 400;
    for (int k = 1; k < n; ++k) {
      const double angle = std::numbers::pi * (static_cast<double>(k) / n - 0.5);
      const double x = 0.5 * width * std::sin(angle);
      sum += window_plain(x, width, shape) * std::cos(xi * x) * 0.5 * width * std::cos(angle);
    }
    CAPTURE(xi);
    CHECK(std::abs(window.transform(xi) - sum * std::numbers::pi / n) <
          1e-8 * window.transform(0.0));
  }
}

TEST_CASE("a window has two to sixteen lines") {
  CHECK_THROWS_AS(Window(1, 3.0, 1e-9), std::invalid_argument);
  CHECK_THROWS_AS(Window(17, 3.0, 1e-9), std::invalid_argument);
}

TEST_CASE("the spectrum of a finite vortex is 1 - J0 to round-off, near and far") {
  const double reach = 300.0;
  const bench::VortexSpectrum spectrum(reach, 4.5);
  for (double k = 0.0; k <= 4.5; k += 0.00371) {
    CAPTURE(k);
    REQUIRE(std::abs(spectrum.felt(k) - (1.0 - ::j0(reach * k))) < 1e-13);
  }
}

TEST_CASE("transform lengths are even, smooth and not much longer than asked for") {
  for (int n = 1; n < 5000; n += 7) {
    const int length = bench::smooth_length(n);
    REQUIRE(length >= n);
    REQUIRE(length % 2 == 0);
    REQUIRE(length <= n + 2 + n / 6);
    int rest = length;
    for (const int prime : {2, 3, 5, 7})
      while (rest % prime == 0) rest /= prime;
    REQUIRE(rest == 1);
  }
}
