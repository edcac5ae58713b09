#include "bench/rivals/velocity/window.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace vortree::bench {
namespace {

// Modified Bessel function I0; all terms are positive, so nothing cancels.
double bessel_i0(double x) {
  const double q = x * x / 4.0;
  double term = 1.0, sum = 1.0;
  for (int k = 1; term > 1e-17 * sum; ++k) {
    term *= q / (static_cast<double>(k) * k);
    sum += term;
  }
  return sum;
}

constexpr int most_terms = 24;  // enough for round-off with every width

// Powers of s of the polynomial through the values at the Chebyshev points of [-1, 1].
std::vector<double> powers_through(const std::vector<double>& values) {
  const int n = static_cast<int>(values.size());
  std::vector<double> sum(n, 0.0), last(n, 0.0), current(n, 0.0);
  current[0] = 1.0;  // T_0, then T_1 = s T_0, then T_(m+1) = 2 s T_m - T_(m-1)
  for (int m = 0; m < n; ++m) {
    double share = 0.0;
    for (int i = 0; i < n; ++i) share += values[i] * std::cos(std::numbers::pi * m * (i + 0.5) / n);
    share *= (m == 0 ? 1.0 : 2.0) / n;
    for (int k = 0; k < n; ++k) sum[k] += share * current[k];
    std::vector<double> next(n, 0.0);
    for (int k = 0; k + 1 < n; ++k) next[k + 1] = (m == 0 ? 1.0 : 2.0) * current[k];
    for (int k = 0; k < n; ++k) next[k] -= last[k];
    last = current;
    current = next;
  }
  return sum;
}

}  // namespace

Window::Window(int width, double shape, double accuracy)
    : width_(width), degree_(0), shape_(shape) {
  if (width < 2 || width > most_width)
    throw std::invalid_argument("window width is " + std::to_string(width) +
                                "; it must be in 2 .. " + std::to_string(most_width));
  scale_ = 1.0 / bessel_i0(shape);
  std::vector<std::vector<double>> powers;
  for (int j = 0; j < width; ++j) {
    std::vector<double> values(most_terms);
    for (int i = 0; i < most_terms; ++i) {
      const double t = 0.5 + 0.5 * std::cos(std::numbers::pi * (i + 0.5) / most_terms);
      const double q = 2.0 * (j + t) / width - 1.0;
      values[i] = scale_ * bessel_i0(shape * std::sqrt(std::max(0.0, 1.0 - q * q)));
    }
    powers.push_back(powers_through(values));
    for (int k = degree_ + 1; k < most_terms; ++k)
      if (std::abs(powers[j][k]) > accuracy) degree_ = k;
  }
  const int room = vectors() * lanes;
  terms_.assign(static_cast<std::size_t>(degree_ + 1) * room, 0.0);
  for (int k = 0; k <= degree_; ++k)
    for (int j = 0; j < width; ++j) terms_[(degree_ - k) * room + j] = powers[j][k];
}

double Window::transform(double xi) const {
  const double a = 0.5 * width_ * xi, q = shape_ * shape_ - a * a;
  const double root = std::sqrt(std::abs(q));
  if (root < 1e-8) return width_ * scale_;
  return width_ * scale_ * (q > 0.0 ? std::sinh(root) : std::sin(root)) / root;
}

}  // namespace vortree::bench
