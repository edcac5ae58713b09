#include "sph/pressure/diagonal_dominant.hpp"

#include <algorithm>
#include <vector>

#include "sph/pressure/bicgstab.hpp"
#include "sph/pressure/sliced_kernel.hpp"

namespace vortree::sph {
namespace {

using kernel::SlicedPairs;
using BothSides = std::array<double, 2>;

/// What floats find out of a residual, in what it was at first.
constexpr double floats = 1e-6;

/// As floats, padded, and each for both sides of a row.
SlicedPairs for_both(std::span<const double> of, std::size_t padded) {
  SlicedPairs made(2 * padded);
  for (std::size_t i = 0; i < of.size(); ++i)
    made[2 * i] = made[2 * i + 1] = static_cast<float>(of[i]);
  return made;
}

/// 1 / diagonal: value_i - factor_i a_ii.
SlicedPairs inverse_diagonals(const DiagonalDominant& of) {
  SlicedPairs made(2 * of.a.padded());
#pragma omp parallel for schedule(static) if (of.a.rows > kernel::rows_worth_sharing)
  for (std::size_t i = 0; i < of.a.rows; ++i) {
    const std::size_t slice = i / SlicedRows::lanes;
    const double own = of.a.value[of.a.begin[slice] * SlicedRows::lanes + i % SlicedRows::lanes];
    made[2 * i] = made[2 * i + 1] = static_cast<float>(1 / (of.value[i] - of.factor[i] * own));
  }
  return made;
}

/// b - A x of a side.
void find_residual(const DiagonalDominant& of, std::span<const double> b, std::span<const double> x,
                   std::vector<double>& left) {
  const std::size_t n = b.size();
  left.resize(n);
  kernel::for_slices<true>(of.a, x.data(), [&](std::size_t from, Lanes sums) {
    for (std::size_t i = from; i < std::min<std::size_t>(from + lane_count, n); ++i)
      left[i] = b[i] - of.value[i] * x[i] + of.factor[i] * sums[static_cast<int>(i - from)];
  });
}

/// Corrections in floats of what is left.
class Corrections {
 public:
  explicit Corrections(const DiagonalDominant& of)
      : of_(of),
        value_(for_both(of.value, of.a.padded())),
        factor_(for_both(of.factor, of.a.padded())),
        inverse_(inverse_diagonals(of)),
        right_(2 * of.a.padded()),
        found_(2 * of.a.padded()) {}

  /// x += what makes `left` smaller by `reduction`; returns the share of it that is still left.
  std::array<Solved, 2> add(const std::array<std::vector<double>, 2>& left, double reduction,
                            int most, std::array<std::span<double>, 2> x) {
    const std::size_t n = of_.a.rows;
#pragma omp parallel for schedule(static) if (n > kernel::rows_worth_sharing)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t s = 0; s < 2; ++s)
        right_[2 * i + s] = static_cast<float>(left[s][i]), found_[2 * i + s] = 0;
    const auto multiply = [&](std::span<const float> in, std::span<float> out) { apply(in, out); };
    const auto precondition = [&](std::span<const float> in, std::span<float> out) {
#pragma omp parallel for simd schedule(static) if (n > kernel::rows_worth_sharing)
      for (std::size_t i = 0; i < 2 * n; ++i) out[i] = in[i] * inverse_[i];
    };
    Bicgstab<2, float, decltype(multiply), decltype(precondition)> method(of_.a.padded(), multiply,
                                                                          precondition);
    const auto told = method.solve(right_, found_, reduction, most);
#pragma omp parallel for schedule(static) if (n > kernel::rows_worth_sharing)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t s = 0; s < 2; ++s) x[s][i] += found_[2 * i + s];
    return told;
  }

 private:
  void apply(std::span<const float> x, std::span<float> y) {
    kernel::for_slices_of_pairs(of_.singles, x.data(), [&](std::size_t i, Singles sums) {
      const Singles own = load(x.data() + 2 * i);
      store(y.data() + 2 * i,
            load(value_.data() + 2 * i) * own - load(factor_.data() + 2 * i) * sums);
    });
  }

  const DiagonalDominant& of_;
  SlicedPairs value_, factor_, inverse_, right_, found_;
};

}  // namespace

std::array<Solved, 2> solve(const DiagonalDominant& system,
                            std::array<std::span<const double>, 2> b,
                            std::array<std::span<double>, 2> x, double tolerance, int most) {
  constexpr int rounds = 4;
  const std::size_t n = system.a.rows;
  std::array<std::vector<double>, 2> left;
  std::array<Solved, 2> told;
  BothSides whole;
  for (std::size_t s = 0; s < 2; ++s) {
    check_vectors(n, b[s], x[s]);
    whole[s] = norm(b[s]);
    if (whole[s] == 0) std::ranges::fill(x[s], 0);
  }
  Corrections corrections(system);
  for (int round = 0; round < rounds; ++round) {
    BothSides size{};
    double reduction = 1;
    for (std::size_t s = 0; s < 2; ++s) {
      find_residual(system, b[s], x[s], left[s]);
      size[s] = norm(left[s]);
      told[s].residual = whole[s] > 0 ? size[s] / whole[s] : 0;
      if (told[s].residual > tolerance)
        reduction = std::min(reduction, 0.5 * tolerance / told[s].residual);
    }
    if (reduction == 1 || told[0].iterations >= most) break;
    const auto made =
        corrections.add(left, std::max(reduction, floats), most - told[0].iterations, x);
    bool sure = true;
    for (std::size_t s = 0; s < 2; ++s) {
      told[s].iterations += made[s].iterations;
      told[s].residual *= made[s].residual + floats;
      sure = sure && told[s].residual <= tolerance;
    }
    if (sure) break;
  }
  return told;
}

}  // namespace vortree::sph
