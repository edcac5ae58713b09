// GCC 12 takes the undefined lanes of its own AVX-512 intrinsics, as Eigen uses them, for a
// mistake.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"

#include "vortex/wall/linear_system.hpp"

#include <Eigen/LU>
#include <cassert>

namespace vortree::vortex {

struct LinearSystem::Factors {
  Eigen::PartialPivLU<Eigen::MatrixXd> lu;
};

LinearSystem::LinearSystem(std::span<const double> matrix, std::size_t n) {
  assert(matrix.size() == n * n);
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const auto size = static_cast<Eigen::Index>(n);
  const Eigen::Map<const RowMajor> a(matrix.data(), size, size);
  factors_ = std::make_unique<Factors>(Factors{Eigen::PartialPivLU<Eigen::MatrixXd>(a)});
}

LinearSystem::~LinearSystem() = default;
LinearSystem::LinearSystem(LinearSystem&&) noexcept = default;
LinearSystem& LinearSystem::operator=(LinearSystem&&) noexcept = default;

std::vector<double> LinearSystem::solve(std::span<const double> right) const {
  const Eigen::Map<const Eigen::VectorXd> b(right.data(), std::ssize(right));
  const Eigen::VectorXd x = factors_->lu.solve(b);
  return {x.begin(), x.end()};
}

}  // namespace vortree::vortex
