#include "sph/pressure/diagonal_dominant.hpp"

#include <vector>

#include "sph/pressure/bicgstab.hpp"
#include "sph/pressure/multiply.hpp"

namespace vortree::sph {
namespace {

template <std::size_t sides>
std::array<Solved, sides> solve_sides(const SparseRows& rows, std::span<const double> b,
                                      std::span<double> x, double tolerance, int most) {
  const auto multiply = [&](auto in, auto out) { sph::multiply<sides>(rows, in, out); };
  const auto precondition = [&](auto in, auto out) {
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t s = i * sides; s < (i + 1) * sides; ++s) out[s] = in[s] / rows.diagonal[i];
  };
  return Bicgstab<sides, decltype(multiply), decltype(precondition)>(rows.size(), multiply,
                                                                     precondition)
      .solve(b, x, tolerance, most);
}

template <class Numbers>
std::vector<double> side_by_side(const std::array<Numbers, 2>& sides) {
  std::vector<double> both(2 * sides[0].size());
  for (std::size_t i = 0; i < both.size(); ++i) both[i] = sides[i % 2][i / 2];
  return both;
}

}  // namespace

Solved solve_diagonal_dominant(const SparseRows& rows, std::span<const double> b,
                               std::span<double> x, double tolerance, int most) {
  check(rows);
  check_vectors(rows, b, x);
  return solve_sides<1>(rows, b, x, tolerance, most)[0];
}

std::array<Solved, 2> solve_diagonal_dominant(const SparseRows& rows,
                                              std::array<std::span<const double>, 2> b,
                                              std::array<std::span<double>, 2> x, double tolerance,
                                              int most) {
  check(rows);
  for (std::size_t s = 0; s < 2; ++s) check_vectors(rows, b[s], x[s]);
  std::vector<double> both = side_by_side(x);
  const auto told = solve_sides<2>(rows, side_by_side(b), both, tolerance, most);
  for (std::size_t i = 0; i < both.size(); ++i) x[i % 2][i / 2] = both[i];
  return told;
}

}  // namespace vortree::sph
