#pragma once

#include <array>

#include "fmm/series/translation_kernel.hpp"

namespace vortree::fmm {

/// Terms of both series for each orbit of M2L, and the most of them.
struct LatticeOrder {
  /// Beyond, doubles have no digits left.
  static constexpr int most_known = 72;

  int most = 0;
  std::array<int, orbit_count> terms{};

  /// The same number of terms for all.
  static LatticeOrder fixed(int terms);
  /// As few terms as keep expected_error below a third of the tolerance: clusters that sit in the
  /// corners of their cells may err twice as much as is expected (tests/fmm/hard_cases.cpp).
  static LatticeOrder for_tolerance(double tolerance);
};

/// The relative L2 error to expect of evenly filled cells and circulations of random sign, which
/// leave nothing but near sums and errors to add up; one-signed clouds err less.
///
/// Of a source at t and a target at t' in cells D apart, both series cut at p terms lose
/// t^k (D + t')^-(k+1) and t'^k (D + t)^-(k+1) for k >= p, which are as good as orthogonal:
///
///   E^2(D, p) = 2 sum_{k >= p} <|t|^(2k)> <|D + t|^-2(k+1)>,   averages over a cell of side 1
///
/// A level of m points a cell loses m E^2 in f for every D in V; f itself is 2 pi m ln(R/r) from
/// rings between the nearest points and the whole cloud. So with n(D) places at a distance, some 8
/// levels and ln(R/r) near 10,
///
///   error^2 = 8 sum_D n(D) E^2(D, p(D)) / (20 pi)
///
/// It foretells uniform clouds within a tenth (tests/fmm/series/orders.cpp).
[[nodiscard]] double expected_error(const LatticeOrder& order);

/// <|t|^(2k)>, the average over a cell of side 1.
[[nodiscard]] double mean_power(int k);

}  // namespace vortree::fmm
