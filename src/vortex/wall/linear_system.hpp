#pragma once

#include <memory>
#include <span>
#include <vector>

namespace vortree::vortex {

/// A dense square system, factorised once (LU with partial pivoting) and solved many times.
/// cost  O(n^3) once, O(n^2) a solution
class LinearSystem {
 public:
  /// matrix  n x n, row by row
  LinearSystem(std::span<const double> matrix, std::size_t n);
  ~LinearSystem();
  LinearSystem(LinearSystem&&) noexcept;
  LinearSystem& operator=(LinearSystem&&) noexcept;

  std::vector<double> solve(std::span<const double> right) const;

 private:
  struct Factors;
  std::unique_ptr<Factors> factors_;
};

}  // namespace vortree::vortex
