#include "fmm/series/lattice_order.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace vortree::fmm {
namespace {

constexpr int most_known = LatticeOrder::most_known;
constexpr double levels = 8, rings = 20 * std::numbers::pi;

/// Places of V at each orbit's distance: the mean over the four children, orbit by orbit.
constexpr std::array<double, orbit_count> make_counts() {
  std::array<double, orbit_count> counts{};
  for (const auto& child : orbit_places) {
    for (int o = 0; o < orbit_count; ++o) {
      for (const int place : child[o]) counts[o] += place >= 0 ? 0.25 : 0.0;
    }
  }
  return counts;
}
constexpr auto counts = make_counts();

/// n(D) E^2(D, p) 8/(20 pi) by orbit and p.
using Losses = std::array<std::array<double, most_known + 1>, orbit_count>;

/// Averages over a cell of side 1 by the Chebyshev points of both directions, which crowd where the
/// high powers live: at the rim.
Losses compute_losses() {
  constexpr int n = 32;
  std::array<double, n> place{}, weight{};
  for (int i = 0; i < n; ++i) {
    const double angle = std::numbers::pi * (i + 0.5) / n;
    place[i] = 0.5 * std::cos(angle);
    weight[i] = std::numbers::pi / (2 * n) * std::sin(angle);
  }
  std::array<std::array<double, most_known>, orbit_count> outside{};
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double area = weight[i] * weight[j];
      for (int o = 0; o < orbit_count; ++o) {
        const double x = orbits[o].x + place[i], y = orbits[o].y + place[j];
        const double inverse = 1 / (x * x + y * y);
        double power = area * inverse;
        for (int k = 0; k < most_known; ++k, power *= inverse) outside[o][k] += power;
      }
    }
  }
  Losses losses{};
  for (int o = 0; o < orbit_count; ++o) {
    for (int k = most_known - 1; k >= 0; --k) {
      losses[o][k] =
          losses[o][k + 1] + 2 * mean_power(k) * outside[o][k] * counts[o] * levels / rings;
    }
  }
  return losses;
}

const Losses& losses() {
  static const Losses known = compute_losses();
  return known;
}

}  // namespace

LatticeOrder LatticeOrder::fixed(int terms) {
  LatticeOrder order{.most = terms};
  order.terms.fill(terms);
  return order;
}

LatticeOrder LatticeOrder::for_tolerance(double tolerance) {
  LatticeOrder order;
  const double share = tolerance * tolerance / 9 / orbit_count;
  for (int o = 0; o < orbit_count; ++o) {
    int terms = 1;
    while (terms < most_known && losses()[o][terms] > share) ++terms;
    order.terms[o] = terms;
    order.most = std::max(order.most, terms);
  }
  return order;
}

/// By the binomial of (x^2 + y^2)^k, <x^(2m)> = 4^-m/(2m + 1).
double mean_power(int k) {
  double sum = 0.0, binomial = std::pow(0.25, k);
  for (int m = 0; m <= k; ++m) {
    sum += binomial / ((2 * m + 1.0) * (2 * (k - m) + 1.0));
    binomial *= (k - m) / (m + 1.0);
  }
  return sum;
}

double expected_error(const LatticeOrder& order) {
  double squared = 0.0;
  for (int o = 0; o < orbit_count; ++o) {
    squared += losses()[o][std::min(order.terms[o], most_known)];
  }
  return std::sqrt(squared);
}

}  // namespace vortree::fmm
