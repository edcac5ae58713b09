#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "fmm/options.hpp"
#include "fmm/sources.hpp"

namespace vortree::test {

/// Velocity, gradient and stream function at a target by long double sums over every pair, whose
/// weights are as exact as long doubles, and the sums of |contributions|: where sums cancel, what
/// doubles can hold is measured by those.
struct Whole {
  long double u = 0, v = 0, ux = 0, uy = 0, vx = 0, psi = 0;
  long double all_u = 0, all_slopes = 0, all_psi = 0;

  void add(long double g, long double dx, long double dy, long double core) {
    const long double r2 = dx * dx + dy * dy, q = core > 0 ? r2 / core : 0;
    if (r2 == 0 && core == 0) return;
    const long double turn = core > 0 ? g * std::exp(-q) / core : 0;
    const long double log =
        core > 0 ? g * (r2 > 0 ? std::log(r2) + e1(q) : std::log(core) - euler) : g * std::log(r2);
    psi -= log / 2, all_psi += std::abs(log / 2);
    vx += turn, uy -= turn, all_slopes += std::abs(turn);
    if (r2 == 0) return;
    const long double w = (core > 0 ? -std::expm1(-q) : 1) * g / r2;
    const long double strain = (core > 0 ? strained(q) : 1) * g / r2;
    u -= w * dy, v += w * dx, all_u += std::abs(w) * std::sqrt(r2);
    const long double along = strain * 2 * dx * dy / r2;
    const long double across = strain * (dy - dx) * (dy + dx) / r2;
    ux += along, uy += across, vx += across, all_slopes += std::abs(strain);
  }

 private:
  static constexpr long double euler = 0.57721566490153286060651209L;

  /// 1 - (1 + q) exp(-q), by its series where digits would be lost.
  static long double strained(long double q) {
    if (q > 0.1L) return 1 - (1 + q) * std::exp(-q);
    long double sum = 0, power = q;
    for (int k = 2; k < 20; ++k) {
      power *= -q / k;
      sum -= power * (k - 1);
    }
    return sum;
  }
  /// E1(q) by its series, or by its continued fraction (Abramowitz & Stegun 5.1.11, 5.1.22).
  static long double e1(long double q) {
    if (q > 100) return 0;
    if (q > 2) {
      long double fraction = 0;
      for (int k = 200; k > 0; --k) fraction = k / (1 + k / (q + fraction));
      return std::exp(-q) / (q + fraction);
    }
    long double sum = -euler - std::log(q), power = 1;
    for (int k = 1; k < 60; ++k) {
      power *= -q / k;
      sum -= power / k;
    }
    return sum;
  }
};

inline std::vector<Whole> whole_reference(const fmm::Sources& blobs, const fmm::Targets& targets,
                                          fmm::Cores cores) {
  const auto square = [](std::span<const double> sigma, std::size_t i) -> long double {
    return sigma.empty() ? 0.0L : static_cast<long double>(sigma[i]) * sigma[i];
  };
  std::vector<Whole> exact(targets.size());
  for (std::size_t i = 0; i < targets.size(); ++i) {
    for (std::size_t j = 0; j < blobs.size(); ++j) {
      const long double own = square(blobs.sigma, j);
      exact[i].add(blobs.gamma[j] / (2 * std::numbers::pi_v<long double>),
                   static_cast<long double>(targets.x[i]) - blobs.x[j],
                   static_cast<long double>(targets.y[i]) - blobs.y[j],
                   cores == fmm::Cores::source ? own : (own + square(targets.sigma, i)) / 2);
    }
  }
  return exact;
}

/// ||found - exact||_2 over what is promised of it, max(tolerance ||exact||_2, round_off ||sum of
/// |contributions|||_2): the promise is kept if it is no more than 1.
class Kept {
 public:
  explicit Kept(double tolerance) : tolerance_(tolerance) {}

  void add(long double missed, long double exact, int times = 1) {
    missed_ += times * missed * missed, exact_ += times * exact * exact;
  }
  void add_contributions(long double all) { all_ += all * all; }
  [[nodiscard]] double ratio() const {
    if (missed_ == 0) return 0;
    return static_cast<double>(std::sqrt(missed_) / std::max(tolerance_ * std::sqrt(exact_),
                                                             fmm::round_off * std::sqrt(all_)));
  }

 private:
  long double tolerance_, missed_ = 0, exact_ = 0, all_ = 0;
};

}  // namespace vortree::test
