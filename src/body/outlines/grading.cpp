#include "body/outlines/grading.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "body/outlines/panel_limits.hpp"

namespace vortree::body {
namespace {

/// Panels from where a cell is smoothed to where that is less than round-off.
constexpr int reach = 8;

/// By how much cells may differ and be even.
constexpr double round_off = 1e-9;

/// The share of a cell that lies before a place, seen from its middle.
double before(double t) {
  return std::erfc(-t / std::numbers::sqrt2) / 2;
}

double bell(double t) {
  return std::exp(-t * t / 2) / std::sqrt(2 * std::numbers::pi);
}

}  // namespace

Grading::Grading(const Shape& shape, int panels) : Grading(shape.perimeter(), panels) {
  const std::vector<double> edges = PanelLimits(shape).edges(panels);
  std::vector<double> cells;
  for (int k = 0; k < panels; ++k) cells.push_back(edges[k + 1] - edges[k]);
  const auto [least, most] = std::ranges::minmax(cells);
  if (most - least <= round_off * most) return;
  cells_ = std::move(cells);
  edges_ = edges;
  shift_ = arc(0);
}

double Grading::arc(double t) const {
  if (even()) return t * mean_;
  const auto n = static_cast<int>(cells_.size()), first = static_cast<int>(std::floor(t)) - reach,
             from = (first % n + n) % n;
  double sum = edges_[from] + (first - from) * mean_ - shift_;
  for (int k = 0; k < 2 * reach + 1; ++k)
    sum += cells_[(from + k) % n] * before(t - first - k - 0.5);
  return sum;
}

double Grading::length(double t) const {
  if (even()) return mean_;
  const auto n = static_cast<int>(cells_.size()), first = static_cast<int>(std::floor(t)) - reach,
             from = (first % n + n) % n;
  double sum = 0;
  for (int k = 0; k < 2 * reach + 1; ++k) sum += cells_[(from + k) % n] * bell(t - first - k - 0.5);
  return sum;
}

}  // namespace vortree::body
