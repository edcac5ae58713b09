#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

#include "fmm/cores/core_log_kernel.hpp"
#include "fmm/sources.hpp"

namespace vortree::test {

/// Gradient and stream function at a target, by long double sums over every pair.
struct ExactFields {
  long double ux = 0, uy = 0, vx = 0, psi = 0;

  void add_bare(long double g, long double dx, long double dy) {
    const long double r2 = dx * dx + dy * dy;
    if (r2 == 0) return;
    ux += g * 2 * dx * dy / (r2 * r2);
    uy += g * (dy * dy - dx * dx) / (r2 * r2);
    vx += g * (dy * dy - dx * dx) / (r2 * r2);
    psi -= g * std::log(r2) / 2;
  }

  /// u = -g dy w, v = g dx w with w = (1 - exp(-q))/r^2; slope = dw/d(r^2), by its series where q
  /// is small.
  void add_cored(long double g, long double dx, long double dy, long double core) {
    const long double r2 = dx * dx + dy * dy, q = r2 / core;
    long double w = (1 - q / 2 + q * q / 6) / core;
    long double slope = -(0.5L - q / 3 + q * q / 8) / (core * core);
    if (q > 1e-6L) {
      w = -std::expm1(-q) / r2;
      slope = (std::exp(-q) / core - w) / r2;
    }
    ux -= g * dy * slope * 2 * dx;
    uy -= g * (w + dy * slope * 2 * dy);
    vx += g * (w + dx * slope * 2 * dx);
    psi -= g * (std::log(core) + fmm::core_log_plain(q)) / 2;
  }
};

inline std::vector<ExactFields> exact_fields(const fmm::Sources& blobs, const fmm::Targets& targets,
                                             fmm::Cores cores) {
  const auto square = [](std::span<const double> sigma, std::size_t i) -> long double {
    return sigma.empty() ? 0.0L : static_cast<long double>(sigma[i]) * sigma[i];
  };
  std::vector<ExactFields> exact(targets.size());
  for (std::size_t i = 0; i < targets.size(); ++i) {
    for (std::size_t j = 0; j < blobs.size(); ++j) {
      const long double dx = static_cast<long double>(targets.x[i]) - blobs.x[j];
      const long double dy = static_cast<long double>(targets.y[i]) - blobs.y[j];
      const long double own = square(blobs.sigma, j);
      const long double core =
          cores == fmm::Cores::source ? own : (own + square(targets.sigma, i)) / 2;
      const long double g = blobs.gamma[j] / (2 * std::numbers::pi_v<long double>);
      if (dx * dx + dy * dy > 80 * core || core == 0) {
        exact[i].add_bare(g, dx, dy);
      } else {
        exact[i].add_cored(g, dx, dy, core);
      }
    }
  }
  return exact;
}

/// What a plan says at some targets.
struct Fields {
  std::vector<double> ux, uy, vx, psi;

  explicit Fields(std::size_t n) : ux(n, 7.0), uy(ux), vx(ux), psi(ux) {}

  template <class Plan>
  Fields(const Plan& plan, const fmm::Targets& targets) : Fields(targets.size()) {
    plan.gradient(targets, ux, uy, vx);
    plan.stream_function(targets, psi);
  }
};

/// ||found - exact||_2 / ||exact||_2 of all four components, and of psi.
struct FieldErrors {
  double gradient, stream_function;
};

inline FieldErrors errors_of(const Fields& found, const std::vector<ExactFields>& exact) {
  const auto square = [](long double a) { return a * a; };
  long double wrong = 0, whole = 0, psi_wrong = 0, psi_whole = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const ExactFields& e = exact[i];
    wrong +=
        2 * square(found.ux[i] - e.ux) + square(found.uy[i] - e.uy) + square(found.vx[i] - e.vx);
    whole += 2 * square(e.ux) + square(e.uy) + square(e.vx);
    psi_wrong += square(found.psi[i] - e.psi);
    psi_whole += square(e.psi);
  }
  return {static_cast<double>(std::sqrt(wrong / whole)),
          static_cast<double>(std::sqrt(psi_wrong / psi_whole))};
}

}  // namespace vortree::test
