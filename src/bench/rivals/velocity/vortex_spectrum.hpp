#pragma once

#include <vector>

namespace vortree::bench {

/// Spectrum of a vortex that is felt up to a distance only:
///
///   psi(r) = -ln(r/reach)/(2 pi) for r < reach, 0 beyond;   hat psi(k) = (1 - J0(reach k)) / k^2
///
/// Its velocity within the reach is that of a whole vortex; being of finite size it can be repeated
/// in space without being felt by its copies, and its spectrum can be sampled.
///
/// reach, largest   the spectrum is asked for with 0 <= k <= largest
/// error            1e-15 of 1/k^2
/// cost             made once: 100 ns for each 1/4 of reach * largest; then some ns a value
/// source           Vico, Greengard & Ferrando, J. Comput. Phys. 323 (2016)
class VortexSpectrum {
 public:
  VortexSpectrum(double reach, double largest);

  /// 1 - J0(reach k)
  [[nodiscard]] double felt(double k) const {
    const double place = reach_ * k * per_unit;
    const int node = static_cast<int>(place + 0.5);
    const double t = place - node;
    const double* term = &terms_[static_cast<std::size_t>(node) * count];
    double sum = term[0];
    for (int i = 1; i < count; ++i) sum = sum * t + term[i];
    return sum;
  }

 private:
  static constexpr int per_unit = 4, count = 10;  // Taylor series about every quarter

  double reach_;
  std::vector<double> terms_;  // the highest power of t first
};

}  // namespace vortree::bench
