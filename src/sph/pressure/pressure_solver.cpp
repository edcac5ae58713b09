#include "sph/pressure/pressure_solver.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "sph/pressure/bicgstab.hpp"
#include "sph/pressure/gmres.hpp"
#include "sph/pressure/incomplete_lu.hpp"
#include "sph/pressure/multigrid.hpp"
#include "sph/pressure/sliced_kernel.hpp"
#include "sph/pressure/sparse_rows.hpp"

namespace vortree::sph {
namespace {

using PressureColumn = std::vector<double>;

/// A 1.
PressureColumn sums_of_rows(const SlicedDoubles& a) {
  PressureColumn sums(a.padded());
#pragma omp parallel for schedule(static) if (a.slices() > kernel::slices_worth_sharing)
  for (std::size_t slice = 0; slice < a.slices(); ++slice)
    for (std::size_t k = a.begin[slice] * SlicedDoubles::lanes;
         k < a.begin[slice + 1] * SlicedDoubles::lanes; k += SlicedDoubles::lanes)
      for (std::size_t lane = 0; lane < SlicedDoubles::lanes; ++lane)
        sums[slice * SlicedDoubles::lanes + lane] += a.value[k + lane];
  sums.resize(a.rows);
  return sums;
}

}  // namespace

class PressureSolver::Prepared {
 public:
  void prepare(const SlicedDoubles& rows) {
    rows_ = &rows;
    multigrid_.prepare(rows);
    gmres_.prepare(multigrid_, sums_of_rows(rows));
  }

  [[nodiscard]] const SlicedRows& matrix() const { return multigrid_.matrix(); }

  Solved solve(std::span<const double> b, std::span<double> x, double tolerance, int most) {
    check_vectors(rows_->rows, b, x);
    const double whole = norm(b);
    if (whole == 0) {
      std::ranges::fill(x, 0);
      return {};
    }
    Solved told{0, residual(b, x) / whole};
    refine(b, x, tolerance, most, whole, told);
    if (told.residual > tolerance && told.iterations < most)
      iterate_slowly(b, x, tolerance, most, told);
    return told;
  }

 private:
  double residual(std::span<const double> b, std::span<const double> x) {
    left_.assign(b.begin(), b.end());
    left_.resize(rows_->padded());
    kernel::for_slices<false>(*rows_, x.data(), [&](std::size_t i, Lanes sums) {
      store(left_.data() + i, load(left_.data() + i) - sums);
    });
    left_.resize(b.size());
    return norm(left_);
  }

  // Corrections in floats, as long as each takes at least half of what was left.
  void refine(std::span<const double> b, std::span<double> x, double tolerance, int most,
              double whole, Solved& told) {
    constexpr double safety = 0.9, floats = 1e-5, worth_while = 0.5;
    constexpr int restart = 30;
    for (double before = HUGE_VAL; told.residual > tolerance &&
                                   told.residual < worth_while * before &&
                                   told.iterations < most;) {
      before = told.residual;
      const double reduction = std::max(floats, safety * tolerance / told.residual);
      const PressureColumn old(x.begin(), x.end());
      told.iterations +=
          gmres_.solve(left_, reduction, std::min(restart, most - told.iterations), x);
      told.residual = residual(b, x) / whole;
      if (!(told.residual < before)) {
        std::ranges::copy(old, x.begin());
        told.residual = before;
      }
    }
  }

  void iterate_slowly(std::span<const double> b, std::span<double> x, double tolerance, int most,
                      Solved& told) {
    const SparseRows rows = unsliced(*rows_);
    IncompleteLu factors;
    factors.factor(rows);
    const auto multiply = [&](auto in, auto out) { sph::multiply(rows, in, out); };
    const auto precondition = [&](auto in, auto out) { factors.solve(in, out); };
    Bicgstab<1, double, decltype(multiply), decltype(precondition)> method(rows_->rows, multiply,
                                                                           precondition);
    PressureColumn trial(x.begin(), x.end());
    const Solved slow = method.solve(b, trial, tolerance, most - told.iterations)[0];
    told.iterations += slow.iterations;
    if (!(slow.residual < told.residual)) return;
    told.residual = slow.residual;
    std::ranges::copy(trial, x.begin());
  }

  const SlicedDoubles* rows_ = nullptr;
  Multigrid multigrid_;
  Gmres gmres_;
  PressureColumn left_;
};

PressureSolver::PressureSolver() = default;
PressureSolver::~PressureSolver() = default;
PressureSolver::PressureSolver(PressureSolver&&) noexcept = default;
PressureSolver& PressureSolver::operator=(PressureSolver&&) noexcept = default;

void PressureSolver::prepare(const SlicedDoubles& rows) {
  check(rows);
  if (!prepared_) prepared_ = std::make_unique<Prepared>();
  prepared_->prepare(rows);
}

const SlicedRows& PressureSolver::matrix() const {
  return prepared_->matrix();
}

Solved PressureSolver::solve(std::span<const double> b, std::span<double> x, double tolerance,
                             int most) {
  if (!prepared_) throw std::logic_error("pressure solver: nothing was prepared");
  return prepared_->solve(b, x, tolerance, most);
}

}  // namespace vortree::sph
