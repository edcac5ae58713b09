#pragma once

#include <span>
#include <vector>

#include "sph/cloud/cloud.hpp"
#include "sph/operators/boundary_fits.hpp"
#include "sph/operators/stencils.hpp"
#include "sph/pressure/pressure_solver.hpp"
#include "sph/pressure/sliced_rows.hpp"

namespace vortree::sph {

/// The equation of a potential or a pressure,
///
///   inside     lap p = source
///   boundary   dp/dn = slope, n into the fluid (BoundaryFits)
///   outlet     p = value
///
/// Without an outlet the mean of p is 0 and a weak pin, lap p - 1e-4/A p, A the area of all, keeps
/// it so.
class PressureSystem {
 public:
  /// outlets   hold p; else slopes are given there, too
  void renew(const Cloud& cloud, const Stencils& stencils, const BoundaryFits& fits, bool outlets);

  /// source   of all particles; only those inside count
  /// given    of all particles; slopes of wall and outer nodes, values of outlets
  /// p        first guess in, answer out
  /// throws   std::runtime_error with the residual, if it stays above 100 tolerance, or
  ///          0.01 more than that
  Solved solve(std::span<const double> source, std::span<const double> given, std::span<double> p,
               double tolerance);

  /// Rows inside, V_i lap, and those of nodes; in floats, too.
  [[nodiscard]] const SlicedDoubles& rows() const { return rows_; }
  [[nodiscard]] const SlicedRows& singles() const { return solver_.matrix(); }

 private:
  void rows_inside(const Cloud& cloud, const Stencils& stencils, std::size_t slice);
  void row_of_node(const Cloud& cloud, std::size_t i);

  const Cloud* cloud_ = nullptr;
  const BoundaryFits* fits_ = nullptr;
  bool outlets_ = false, pinned_ = false;
  double pin_ = 0;  // [1/L^2]
  SlicedDoubles rows_;
  PressureSolver solver_;
  std::vector<double> right_;
};

}  // namespace vortree::sph
