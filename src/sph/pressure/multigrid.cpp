// GCC 12 takes the undefined lanes of its own AVX-512 intrinsics, as Eigen uses them, for a
// mistake.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wuninitialized"

#include "sph/pressure/multigrid.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "sph/pressure/aggregates.hpp"
#include "sph/pressure/coarse_rows.hpp"
#include "sph/pressure/near_rows.hpp"

namespace vortree::sph {
namespace {

using kernel::SlicedColumn;

constexpr std::size_t coarsest_rows = 120;

void narrow(const SlicedDoubles& a, SlicedRows& made) {
  made.rows = a.rows, made.begin = a.begin, made.width = a.width;
  made.index.renew(a.index.size()), made.value.renew(a.value.size());
#pragma omp parallel for schedule(static) if (a.slices() > kernel::slices_worth_sharing)
  for (std::size_t slice = 0; slice < a.slices(); ++slice)
    for (std::size_t k = a.begin[slice] * SlicedRows::lanes;
         k < a.begin[slice + 1] * SlicedRows::lanes; k += single_count) {
      const double* from = a.value.data() + k;
      store(made.value.data() + k, narrowed(load(from), load(from + lane_count)));
      store(made.index.data() + k, load(a.index.data() + k));
    }
}

Eigen::MatrixXd dense(const SlicedRows& a) {
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(a.rows, a.rows);
  for (std::size_t i = 0; i < a.rows; ++i)
    a.for_row(i, [&](std::size_t j, float value) { all(i, j) += value; });
  return all;
}

}  // namespace

/// A^-1 of the coarsest level.
class Multigrid::Coarsest {
 public:
  explicit Coarsest(const SlicedRows& a) {
    constexpr double nothing = 1e-4;
    Eigen::MatrixXd all = dense(a);
    const double trace = all.trace(), n = static_cast<double>(a.rows);
    if (std::abs(all.sum()) < nothing * std::abs(trace)) all.array() += trace / (n * n);
    const Eigen::MatrixXd inverse = all.partialPivLu().inverse();
    if (inverse.allFinite())
      inverse_ = inverse.cast<float>();
    else
      inverse_ = Eigen::MatrixXf::Zero(a.rows, a.rows);
  }

  void solve(const Column& b, Column& x) const {
    const Eigen::Index n = inverse_.rows();
    Eigen::Map<Eigen::VectorXf>(x.data(), n).noalias() =
        inverse_ * Eigen::Map<const Eigen::VectorXf>(b.data(), n);
  }

 private:
  Eigen::MatrixXf inverse_;
};

Multigrid::Multigrid() = default;
Multigrid::~Multigrid() = default;
Multigrid::Multigrid(Multigrid&&) noexcept = default;
Multigrid& Multigrid::operator=(Multigrid&&) noexcept = default;

void Multigrid::prepare(const SlicedDoubles& rows) {
  if (levels_.empty()) levels_.emplace_back();
  narrow(rows, matrix_);
  near_rows(matrix_, levels_[0].a);
  depth_ = 1;
  while (levels_[depth_ - 1].a.rows > coarsest_rows && coarsen()) ++depth_;
  coarsest_ = std::make_unique<Coarsest>(levels_[depth_ - 1].a);
}

// One level more, unless there is little to be put together.
bool Multigrid::coarsen() {
  constexpr double worth_while = 0.8;
  if (levels_.size() == depth_) levels_.emplace_back();
  Level& fine = levels_[depth_ - 1];
  find_ties(fine.a, fine.ties);
  const RowAggregates aggregates = aggregate(fine.a, fine.ties);
  if (aggregates.count > worth_while * fine.a.rows) return false;
  sum_over(aggregates, maker_, fine.sums);
  interpolate(fine.a, fine.ties, aggregates, maker_, fine.interpolation);
  coarse_rows(fine.a, fine.sums, fine.interpolation, maker_, levels_[depth_].a);
  for (Column* one : {&fine.smooth, &fine.residual}) one->resize(fine.a.padded());
  for (Column* one : {&fine.coarse_b, &fine.coarse_x}) one->resize(fine.sums.padded());
  return true;
}

void Multigrid::cycle(const Column& b, Column& x) {
  visit(0, b, x, true);
}

void Multigrid::visit(std::size_t l, const Column& b, Column& x, bool is_zero) {
  if (l + 1 == depth_) return coarsest_->solve(b, x);
  Level& at = levels_[l];
  if (is_zero)
    begin_jacobi(at, b, at.smooth);
  else
    jacobi(at, b, x, at.smooth);
  kernel::for_slices(at.a, at.smooth, [&](std::size_t i, Singles sums) {
    store(at.residual.data() + i, load(b.data() + i) - sums);
  });
  correct(l);
  jacobi(at, b, at.smooth, x);
}

// A step from zero.
void Multigrid::begin_jacobi(const Level& at, const Column& b, Column& to) {
#pragma omp parallel for schedule(static) if (at.a.slices() > kernel::slices_worth_sharing)
  for (std::size_t i = 0; i < to.size(); ++i) to[i] = at.ties.inverse[i] * b[i];
}

void Multigrid::jacobi(const Level& at, const Column& b, const Column& from, Column& to) {
  kernel::for_slices(at.a, from, [&](std::size_t i, Singles sums) {
    const Singles left = load(b.data() + i) - sums;
    store(to.data() + i, load(from.data() + i) + load(at.ties.inverse.data() + i) * left);
  });
}

void Multigrid::correct(std::size_t l) {
  Level& at = levels_[l];
  kernel::for_slices(at.sums, at.residual,
                     [&](std::size_t i, Singles sums) { store(at.coarse_b.data() + i, sums); });
  visit(l + 1, at.coarse_b, at.coarse_x, true);
  if (l + 2 < depth_) visit(l + 1, at.coarse_b, at.coarse_x, false);
  kernel::for_slices(at.interpolation, at.coarse_x, [&](std::size_t i, Singles sums) {
    store(at.smooth.data() + i, load(at.smooth.data() + i) + sums);
  });
}

}  // namespace vortree::sph
