#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "base/ordered_sum.hpp"
#include "sph/pressure/sliced_kernel.hpp"
#include "sph/pressure/sparse_rows.hpp"

namespace vortree::sph {

/// BiCGSTAB with a preconditioner M from the right, for several right sides at once: those of a row
/// stand side by side, so that the matrix is read once for all of them.
///
/// Where it breaks down it begins anew from what it has; a step that is not finite is not made. The
/// residual that it tells is that of the answer, not of the recurrence. Same bits for any number of
/// threads.
///
/// Number         of vectors, double or float; their products are summed in doubles
/// multiply       multiply(x, y): y = A x
/// precondition   precondition(r, z): z = M r, linear
/// source         van der Vorst, SIAM J. Sci. Stat. Comput. 13 (1992)
template <std::size_t sides, class Number, class Multiply, class Precondition>
class Bicgstab {
 public:
  using Sides = std::array<double, sides>;  // a number for each right side

  Bicgstab(std::size_t rows, const Multiply& multiply, const Precondition& precondition)
      : n_(rows), multiply_(multiply), precondition_(precondition) {
    for (auto* one : {&r_, &shadow_, &p_, &v_, &t_, &mp_, &mr_}) one->resize(n_ * sides);
  }

  /// b, x   n sides each; x: first guess in, answer out
  std::array<Solved, sides> solve(std::span<const Number> b, std::span<Number> x, double tolerance,
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
  using Column = std::vector<Number>;
  using Factors = std::array<Number, sides>;
  static constexpr int rounds = 5;

  static Factors factors(const Sides& of) {
    Factors made;
    std::ranges::transform(of, made.begin(), [](double one) { return static_cast<Number>(one); });
    return made;
  }

  // Squares of what residuals are to come down to. The answer to zeros is zeros.
  void set_goals(const Sides& whole, std::span<Number> x, double tolerance) {
    for (std::size_t k = 0; k < sides; ++k) {
      goal_[k] = tolerance * tolerance * whole[k];
      for (std::size_t i = k; i < x.size() && whole[k] == 0; i += sides) x[i] = 0;
    }
  }

  // sums[m][k] = (a_m, b) of side k, for one or two vectors a.
  template <class... More>
  auto dots(std::span<const Number> b, std::span<const Number> a, More... more) const {
    const std::array<std::span<const Number>, 1 + sizeof...(more)> all{a, more...};
    const auto flat = ordered_sum(n_, [&](std::size_t first, std::size_t last) {
      std::array<double, all.size() * sides> sum{};
      for (std::size_t m = 0; m < all.size(); ++m)
        add_products(all[m].data(), b.data(), first * sides, last * sides, sum.data() + m * sides);
      return sum;
    });
    std::array<Sides, all.size()> sums;
    for (std::size_t m = 0; m < all.size(); ++m)
      std::copy_n(flat.begin() + m * sides, sides, sums[m].begin());
    return sums;
  }

  static void add_products(const Number* a, const Number* b, std::size_t first, std::size_t last,
                           double* sum) {
    constexpr std::size_t block = 16;
    static_assert(block % sides == 0);
    std::array<double, block> part{};
    std::size_t i = first;
    for (; i + block <= last; i += block)
      for (std::size_t k = 0; k < block; ++k)
        part[k] += static_cast<double>(a[i + k]) * static_cast<double>(b[i + k]);
    for (std::size_t k = 0; i < last; ++i, ++k)
      part[k] += static_cast<double>(a[i]) * static_cast<double>(b[i]);
    for (std::size_t k = 0; k < block; ++k) sum[k % sides] += part[k];
  }

  // formula(i, side) for all numbers of the active sides.
  void for_active(auto formula) const {
    const std::array<bool, sides> active = active_;
    if (std::ranges::find(active, false) == active.end()) return for_all(formula);
    for_all([&](std::size_t i, std::size_t k) {
      if (active[k]) formula(i, k);
    });
  }

  void for_all(auto formula) const {
#pragma omp parallel for schedule(static) if (n_ > kernel::rows_worth_sharing)
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t k = 0; k < sides; ++k) formula(i * sides + k, k);
  }

  bool any_active() const {
    return std::ranges::find(active_, true) != active_.end();
  }

  // The residual, and whose it is still too large.
  bool begin(std::span<const Number> b, std::span<const Number> x) {
    multiply_(x, std::span(r_));
    active_.fill(true);
    for_active([&](std::size_t i, std::size_t) { shadow_[i] = p_[i] = r_[i] = b[i] - r_[i]; });
    left_ = rho_ = dots(r_, r_)[0];
    for (std::size_t k = 0; k < sides; ++k) active_[k] = left_[k] > goal_[k];
    return any_active();
  }

  void iterate(std::span<Number> x) {
    half_step();
    full_step();
    const Factors alpha = factors(alpha_), omega = factors(omega_);
    for_active([&](std::size_t i, std::size_t k) {
      x[i] += alpha[k] * mp_[i] + omega[k] * mr_[i];
      r_[i] -= omega[k] * t_[i];
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
    precondition_(std::span<const Number>(p_), std::span(mp_));
    multiply_(std::span<const Number>(mp_), std::span(v_));
    set_quotient(alpha_, rho_, dots(v_, shadow_)[0]);
    const Factors alpha = factors(alpha_);
    for_active([&](std::size_t i, std::size_t k) { r_[i] -= alpha[k] * v_[i]; });
  }

  void full_step() {
    precondition_(std::span<const Number>(r_), std::span(mr_));
    multiply_(std::span<const Number>(mr_), std::span(t_));
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
    const Factors of = factors(beta), omega = factors(omega_);
    for_active(
        [&](std::size_t i, std::size_t k) { p_[i] = r_[i] + of[k] * (p_[i] - omega[k] * v_[i]); });
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
