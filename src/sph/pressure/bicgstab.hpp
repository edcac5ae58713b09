#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "base/ordered_sum.hpp"
#include "sph/pressure/sparse_rows.hpp"

namespace vortree::sph {

/// BiCGSTAB with a preconditioner M from the right, for several right sides at once: those of a row
/// stand side by side, so that the matrix is read once for all of them.
///
/// Where it breaks down it begins anew from what it has; a step that is not finite is not made. The
/// residual that it tells is that of the answer, not of the recurrence. Same bits for any number of
/// threads.
///
/// multiply       multiply(x, y): y = A x
/// precondition   precondition(r, z): z = M r, linear
/// source         van der Vorst, SIAM J. Sci. Stat. Comput. 13 (1992)
template <std::size_t sides, class Multiply, class Precondition>
class Bicgstab {
 public:
  using Sides = std::array<double, sides>;  // a number for each right side

  Bicgstab(std::size_t rows, const Multiply& multiply, const Precondition& precondition)
      : n_(rows), multiply_(multiply), precondition_(precondition) {
    for (auto* one : {&r_, &shadow_, &p_, &v_, &t_, &mp_, &mr_}) one->resize(n_ * sides);
  }

  /// b, x   n sides each; x: first guess in, answer out
  std::array<Solved, sides> solve(std::span<const double> b, std::span<double> x, double tolerance,
                                  int most) {
    const Sides whole = dots(b, b)[0];
    set_goals(whole, x, tolerance);
    for (int round = 0; round < rounds && begin(b, x) && iterations_ < most; ++round)
      while (any_active() && iterations_ < most) iterate(x);
    begin(b, x);
    std::array<Solved, sides> told;
    for (std::size_t k = 0; k < sides; ++k)
      told[k] = {steps_[k], whole[k] > 0 ? std::sqrt(left_[k] / whole[k]) : 0};
    return told;
  }

 private:
  using Column = std::vector<double>;
  static constexpr int rounds = 5;

  // Squares of what residuals are to come down to. The answer to zeros is zeros.
  void set_goals(const Sides& whole, std::span<double> x, double tolerance) {
    for (std::size_t k = 0; k < sides; ++k) {
      goal_[k] = tolerance * tolerance * whole[k];
      for (std::size_t i = k; i < x.size() && whole[k] == 0; i += sides) x[i] = 0;
    }
  }

  // sums[m][k] = (a_m, b) of side k, for one or two vectors a.
  template <class... More>
  auto dots(std::span<const double> b, std::span<const double> a, More... more) const {
    const std::array<std::span<const double>, 1 + sizeof...(more)> all{a, more...};
    const auto flat = ordered_sum(n_, [&](std::size_t first, std::size_t last) {
      std::array<double, all.size() * sides> sum{};
      for (std::size_t i = first * sides; i < last * sides; i += sides)
        for (std::size_t m = 0; m < all.size(); ++m)
          for (std::size_t k = 0; k < sides; ++k) sum[m * sides + k] += all[m][i + k] * b[i + k];
      return sum;
    });
    std::array<Sides, all.size()> sums;
    for (std::size_t m = 0; m < all.size(); ++m)
      std::copy_n(flat.begin() + m * sides, sides, sums[m].begin());
    return sums;
  }

  // formula(i, side) for all numbers of the active sides.
  void for_active(auto formula) const {
    const std::array<bool, sides> active = active_;
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t k = 0; k < sides; ++k)
        if (active[k]) formula(i * sides + k, k);
  }

  bool any_active() const {
    return std::ranges::find(active_, true) != active_.end();
  }

  // The residual, and whose it is still too large.
  bool begin(std::span<const double> b, std::span<const double> x) {
    multiply_(x, std::span(r_));
    active_.fill(true);
    for_active([&](std::size_t i, std::size_t) { shadow_[i] = p_[i] = r_[i] = b[i] - r_[i]; });
    left_ = rho_ = dots(r_, r_)[0];
    for (std::size_t k = 0; k < sides; ++k) active_[k] = left_[k] > goal_[k];
    return any_active();
  }

  void iterate(std::span<double> x) {
    half_step();
    full_step();
    for_active([&](std::size_t i, std::size_t k) {
      x[i] += alpha_[k] * mp_[i] + omega_[k] * mr_[i];
      r_[i] -= omega_[k] * t_[i];
    });
    turn();
    ++iterations_;
  }

  // A side whose next step is not finite, or none at all, is at its end.
  void set_quotient(Sides& q, const Sides& above, const Sides& below) {
    for (std::size_t k = 0; k < sides; ++k) {
      q[k] = above[k] / below[k];
      active_[k] = active_[k] && std::isfinite(q[k]) && q[k] != 0;
    }
  }

  void half_step() {
    precondition_(std::span<const double>(p_), std::span(mp_));
    multiply_(std::span<const double>(mp_), std::span(v_));
    set_quotient(alpha_, rho_, dots(v_, shadow_)[0]);
    for_active([&](std::size_t i, std::size_t k) { r_[i] -= alpha_[k] * v_[i]; });
  }

  void full_step() {
    precondition_(std::span<const double>(r_), std::span(mr_));
    multiply_(std::span<const double>(mr_), std::span(t_));
    const auto [tr, tt] = dots(t_, r_, t_);
    set_quotient(omega_, tr, tt);
  }

  void turn() {
    const auto [rho, left] = dots(r_, shadow_, r_);
    Sides beta;
    for (std::size_t k = 0; k < sides; ++k) {
      beta[k] = rho[k] / rho_[k] * alpha_[k] / omega_[k];
      steps_[k] += active_[k];
      active_[k] = active_[k] && left[k] > goal_[k] && std::isfinite(beta[k]);
    }
    rho_ = rho;
    for_active([&](std::size_t i, std::size_t k) {
      p_[i] = r_[i] + beta[k] * (p_[i] - omega_[k] * v_[i]);
    });
  }

  std::size_t n_;
  const Multiply& multiply_;
  const Precondition& precondition_;
  Column r_, shadow_, p_, v_, t_, mp_, mr_;
  Sides goal_{}, left_{}, rho_{}, alpha_{}, omega_{};
  std::array<bool, sides> active_{};
  std::array<int, sides> steps_{};
  int iterations_ = 0;
};

}  // namespace vortree::sph
