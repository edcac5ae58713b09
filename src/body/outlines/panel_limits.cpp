#include "body/outlines/panel_limits.hpp"

#include <algorithm>
#include <cmath>

#include "body/outlines/touching_discs.hpp"

namespace vortree::body {
namespace {

constexpr double of_curvature = 0.7, of_disc = 1.25, steepest = 0.3;

/// Mean of 1/x from a to b.
double mean_inverse(double a, double b) {
  if (a == b) return 1 / a;
  return std::abs(b - a) < 1e-4 * a ? 2 / (a + b) : std::log(b / a) / (b - a);
}

/// How far along a side, of 1, int dx/(a + (b - a) x) reaches so much.
double share_reaching(double much, double a, double b) {
  const double turn = (b - a) * much;
  return std::abs(turn) < 1e-8 ? a * much : a * std::expm1(turn) / (b - a);
}

/// Each at most what the others have, and what grows on the way from them.
void bound_growth(std::vector<double>& limits, const std::vector<OutlinePoint>& trace,
                  double perimeter) {
  const std::size_t n = limits.size();
  const auto way = [&](std::size_t from, std::size_t to) {
    const double arc = trace[to].arc - trace[from].arc;
    return arc < 0 ? arc + perimeter : arc;
  };
  for (std::size_t k = 1; k <= 2 * n; ++k) {  // twice around, either way
    const std::size_t i = k % n, before = (k - 1) % n, j = (2 * n - k) % n, after = (j + 1) % n;
    limits[i] = std::min(limits[i], limits[before] + steepest * way(before, i));
    limits[j] = std::min(limits[j], limits[after] + steepest * way(j, after));
  }
}

std::vector<double> limits_of(const Shape& shape, const std::vector<OutlinePoint>& trace) {
  std::vector<double> limits = touching_discs(shape, trace);
  for (std::size_t i = 0; i < limits.size(); ++i)
    limits[i] = std::min(of_disc * limits[i], of_curvature / std::abs(trace[i].curvature));
  bound_growth(limits, trace, shape.perimeter());
  return limits;
}

}  // namespace

PanelLimits::PanelLimits(const Shape& shape) : perimeter_(shape.perimeter()) {
  const std::vector<OutlinePoint> trace = shape.trace();
  const std::vector<double> limits = limits_of(shape, trace);
  for (std::size_t i = 0; i < trace.size(); ++i) {
    const bool last = i + 1 == trace.size();
    const double end = last ? perimeter_ + trace[0].arc : trace[i + 1].arc;
    sides_.push_back({trace[i].arc, end - trace[i].arc, limits[i], limits[last ? 0 : i + 1]});
    farthest_ = std::max(farthest_, limits[i]);
    needed_ += sides_.back().length * mean_inverse(sides_.back().begin, sides_.back().end);
  }
}

double PanelLimits::share_of(double panels) const {
  return panels > needed_ ? std::sqrt(needed_ / panels) : needed_ / panels;
}

double PanelLimits::crowding(double h, double share) const {
  double more = 0;
  for (const Side& side : sides_) {
    const double a = std::min(1.0, share * side.begin / h), b = std::min(1.0, share * side.end / h);
    more += side.length * (mean_inverse(a, b) - 1);
  }
  return 1 + more / perimeter_;
}

double PanelLimits::longest_of(double panels) const {
  const double share = share_of(panels);
  if (panels <= needed_) return share * farthest_;
  double low = perimeter_ / panels, high = perimeter_;
  if (crowding(low, share) == 1) return low;
  for (int k = 0; k < 60; ++k) {
    const double h = std::sqrt(low * high);
    (perimeter_ / h * crowding(h, share) > panels ? low : high) = h;
  }
  return high;
}

/// Shorter limits ask for more panels, which shorten them, by the root alone: this comes to an end.
double PanelLimits::panels_with(double h) const {
  double panels = needed_;
  for (int k = 0; k < 40; ++k)
    panels = std::max(needed_, perimeter_ / h * crowding(h, share_of(panels)));
  return panels;
}

std::vector<double> PanelLimits::edges(int panels) const {
  const double share = share_of(panels), longest = longest_of(panels);
  const auto length = [&](double limit) { return std::min(longest, share * limit); };
  std::vector<double> ends{0};  // of sides, counted in panels
  for (const Side& side : sides_)
    ends.push_back(ends.back() + side.length * mean_inverse(length(side.begin), length(side.end)));
  std::vector<double> edges;
  std::size_t i = 0;
  for (int k = 0; k < panels; ++k) {
    const double at = ends.back() * k / panels;
    while (i + 1 < sides_.size() && ends[i + 1] <= at) ++i;
    const Side& side = sides_[i];
    const double reached = (at - ends[i]) / side.length;
    edges.push_back(side.arc +
                    side.length * share_reaching(reached, length(side.begin), length(side.end)));
  }
  edges.push_back(edges.front() + perimeter_);
  return edges;
}

}  // namespace vortree::body
