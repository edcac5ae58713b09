#include "checks/shedding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>

#include "checks/periodogram.hpp"

namespace vortree::checks {
namespace {

constexpr std::size_t least = 100;  // rows

double mean_of(const Series& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / values.size();
}

double rms_of(const Series& values) {
  const double mean = mean_of(values);
  double sum = 0;
  for (const double one : values) sum += (one - mean) * (one - mean);
  return std::sqrt(sum / values.size());
}

/// What a report says from T = shedding_from on.
class LateRows {
 public:
  explicit LateRows(const Finished& run)
      : rows_(run.rows),
        route_(run.solver.route()),
        bodies_(run.scene.others.size() + 1),
        first_(std::ranges::lower_bound(rows_.T(), run.scene.check.shedding_from.value_or(0)) -
               rows_.T().begin()) {}

  bool too_few() const { return rows_.T().size() < first_ + least; }

  /// cd or cl of all bodies together, and of each.
  Series of_all(std::string_view name) const { return late(fmt::format("{}_{}", name, route_)); }
  std::vector<Series> of_each(std::string_view name) const {
    if (bodies_ == 1) return {of_all(name)};
    std::vector<Series> each;
    for (std::size_t k = 1; k <= bodies_; ++k)
      each.push_back(late(fmt::format("{}_wall_{}", name, k)));
    return each;
  }

  /// A value of each.
  Series of_each(std::string_view name, double (*value)(const Series&)) const {
    Series values;
    for (const Series& one : of_each(name)) values.push_back(value(one));
    return values;
  }

  double dt() const {
    const Series t = late("t");
    return t[1] - t[0];
  }
  /// T runs 2 U/D times as fast as t: D/U.
  double unit() const {
    const Series t = late("t"), T = late("T");
    return 2 * (t.back() - t.front()) / (T.back() - T.front());
  }

 private:
  Series late(std::string_view column) const {
    const Series all = rows_.column(column);
    return {all.begin() + static_cast<std::ptrdiff_t>(first_), all.end()};
  }

  const HistoryRows& rows_;
  std::string route_;
  std::size_t bodies_, first_;
};

/// The largest deviation, as a share of the largest that is known.
double off_each(const Series& ours, const Series& known) {
  Series off;
  for (std::size_t k = 0; k < ours.size(); ++k) off.push_back(ours[k] - known.at(k));
  return share(largest_of(off), largest_of(known));
}

double strouhal_off(const LateRows& rows, double known) {
  Series off;
  for (const Series& lift : rows.of_each("cl"))
    off.push_back(deviation(rows.unit() * dominant_frequency(lift, rows.dt()), known));
  return largest_of(off);
}

/// Of the lifts after the first, in degrees.
double phases_off(const LateRows& rows, const Series& known) {
  const std::vector<Series> lifts = rows.of_each("cl");
  Series off;
  for (std::size_t k = 1; k < lifts.size(); ++k) {
    const double ahead = 180 / std::numbers::pi * phase_ahead(lifts[k], lifts[0], rows.dt());
    off.push_back(std::remainder(ahead - known.at(k - 1), 360));
  }
  return largest_of(off);
}

}  // namespace

void check_shedding(std::vector<Verdict>& list, const Finished& run) {
  if (!run.scales.body) return;
  const io::CheckSettings& c = run.scene.check;
  const LateRows rows(run);
  const auto asked = [&](const char* what, std::optional<double> most,
                         const std::function<double()>& off) {
    add(list, what, most,
        [&] { return rows.too_few() ? run.rows.too_short() : Reached{std::abs(off())}; });
  };
  asked("strouhal_max", c.strouhal_max, [&] { return strouhal_off(rows, c.strouhal.value_or(0)); });
  asked("mean_drag_max", c.mean_drag_max,
        [&] { return deviation(mean_of(rows.of_all("cd")), c.mean_drag.value_or(0)); });
  asked("mean_lift_max", c.mean_lift_max,
        [&] { return deviation(mean_of(rows.of_all("cl")), c.mean_lift.value_or(0)); });
  asked("mean_drag_each_max", c.mean_drag_each_max,
        [&] { return off_each(rows.of_each("cd", mean_of), *c.mean_drag_each); });
  asked("mean_lift_each_max", c.mean_lift_each_max,
        [&] { return off_each(rows.of_each("cl", mean_of), *c.mean_lift_each); });
  asked("lift_rms_each_max", c.lift_rms_each_max,
        [&] { return off_each(rows.of_each("cl", rms_of), *c.lift_rms_each); });
  asked("lift_phases_max_deg", c.lift_phases_max_deg,
        [&] { return phases_off(rows, *c.lift_phases_deg); });
}

}  // namespace vortree::checks
