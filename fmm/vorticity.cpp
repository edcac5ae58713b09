#include "fmm/vorticity.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "fmm/cores/core_kernel.hpp"
#include "fmm/geometry/arrangement.hpp"
#include "fmm/near/packed.hpp"
#include "fmm/tuning.hpp"
#include "tree/base/told.hpp"

namespace vortree::fmm {
namespace {

constexpr double least_core = 1e-150;  // in Units; what is narrower has no extent

struct Peaks {
  const Arrangement& at;
  Reals height;  // gamma / (pi S), in Units
};

/// Sources within reach of a leaf's box.
void collect(const Peaks& peaks, const CellShapes& targets, std::size_t leaf, double reach2,
             PackedSources& near) {
  const CellShapes& shapes = peaks.at.shapes;
  const SortedPoints& points = peaks.at.points;
  std::vector<std::uint32_t> open{0};
  const auto outside = [](double distance, double half) {
    return std::max(0.0, std::abs(distance) - half);
  };
  near.restart(points.size());
  while (!open.empty()) {
    const std::uint32_t c = open.back();
    open.pop_back();
    const double dx = outside(shapes.x[c] - targets.x[leaf], targets.half_x[leaf]);
    const double dy = outside(shapes.y[c] - targets.y[leaf], targets.half_y[leaf]);
    const double gap_x = outside(dx, shapes.half_x[c]), gap_y = outside(dy, shapes.half_y[c]);
    if (gap_x * gap_x + gap_y * gap_y > reach2 * shapes.core[c]) continue;
    const tree::Cell& cell = peaks.at.tree.cells()[c];
    for (std::uint32_t k = cell.children.first; k < cell.children.last; ++k) open.push_back(k);
    if (!cell.childless()) continue;
    for (std::uint32_t j = cell.points.first; j < cell.points.last; ++j) {
      const double x = outside(points.x[j] - targets.x[leaf], targets.half_x[leaf]);
      const double y = outside(points.y[j] - targets.y[leaf], targets.half_y[leaf]);
      if (points.core[j] > least_core && x * x + y * y <= reach2 * points.core[j]) {
        near.add(points.x[j], points.y[j], peaks.height[j], 1.0 / points.core[j]);
      }
    }
  }
  near.close();
}

/// exp(-q) = 1 - core(q): the error is the last bit of the peak.
double sum_at(const PackedSources& near, double x, double y) {
  Lanes omega{};
  for (std::size_t j = 0; j < near.size(); j += lane_count) {
    const Lanes dx = x - load(near.x() + j), dy = y - load(near.y() + j);
    const Lanes q[1] = {(dx * dx + dy * dy) * load(near.core() + j)};
    Lanes lost[1];
    core<FineExp>(q, lost);
    omega += load(near.gamma() + j) * (1.0 - lost[0]);
  }
  return sum(omega);
}

Peaks find_peaks(const Arrangement& at, std::span<const double> gamma, const Units& units) {
  Peaks peaks{at, arrange_gamma(at.tree, gamma, units)};
  for (std::size_t j = 0; j < peaks.height.size(); ++j) {
    peaks.height[j] /= std::numbers::pi * std::max(at.points.core[j], least_core);
  }
  return peaks;
}

void check_door(const Sources& sources, const Targets& targets, std::span<const double> omega,
                double tolerance) {
  check(sources);
  check(targets);
  if (omega.size() != targets.size()) {
    throw std::invalid_argument("omega has " + std::to_string(omega.size()) +
                                " values, the targets are " + std::to_string(targets.size()));
  }
  if (!(tolerance > 0.0 && tolerance < 1.0)) {
    throw std::invalid_argument("tolerance is " + tree::told(tolerance) + "; it must be in (0, 1)");
  }
}

}  // namespace

void vorticity(const Sources& sources, tree::Points targets, std::span<double> omega,
               double tolerance) {
  const Targets places{targets.x, targets.y, {}};
  check_door(sources, places, omega, tolerance);
  std::ranges::fill(omega, 0.0);
  if (sources.size() == 0 || sources.sigma.empty()) return;
  const Units units = Units::of(sources);
  const Arrangement arranged =
      arrange({sources.x, sources.y, sources.sigma}, units, {vorticity_capacity});
  const Arrangement at = arrange(places, units, {vorticity_capacity});
  const Peaks peaks = find_peaks(arranged, sources.gamma, units);
  const double per_unit = units.per_length / units.per_gamma * units.per_length;
  const auto leaves = at.tree.childless();
#pragma omp parallel
  {
    PackedSources near;
#pragma omp for schedule(dynamic)
    for (std::size_t k = 0; k < leaves.size(); ++k) {
      collect(peaks, at.shapes, leaves[k], std::log(1.0 / tolerance), near);
      const tree::Range own = at.tree.cells()[leaves[k]].points;
      for (std::uint32_t i = own.first; i < own.last; ++i) {
        omega[at.tree.order()[i]] = per_unit * sum_at(near, at.points.x[i], at.points.y[i]);
      }
    }
  }
}

}  // namespace vortree::fmm
