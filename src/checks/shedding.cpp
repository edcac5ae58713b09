#include "checks/shedding.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "checks/periodogram.hpp"

namespace vortree::checks {

void check_shedding(std::vector<Verdict>& list, const Finished& run) {
  if (!run.scales.body) return;
  const io::CheckSettings& c = run.scene.check;
  const HistoryRows& rows = run.rows;
  constexpr std::size_t least = 100;  // rows
  const Series t = rows.column("t"), all_lift = rows.column("cl_" + run.solver.route()),
               all_drag = rows.column("cd_" + run.solver.route());
  const auto first = static_cast<std::ptrdiff_t>(
      std::ranges::lower_bound(rows.T(), c.shedding_from.value_or(0)) - rows.T().begin());
  const Series lift(all_lift.begin() + first, all_lift.end()),
      drag(all_drag.begin() + first, all_drag.end());
  if (lift.size() < least) {
    const auto asked = [&](const char* what, std::optional<double> most) {
      add(list, what, most, [&] { return rows.too_short(); });
    };
    asked("strouhal_max", c.strouhal_max);
    asked("mean_drag_max", c.mean_drag_max);
    asked("mean_lift_max", c.mean_lift_max);
    return;
  }
  add(list, "strouhal_max", c.strouhal_max, [&]() -> Reached {
    // T runs 2 U/D times as fast as t: frequency times D/U.
    const double unit = 2 * (t.back() - t.front()) / (rows.T().back() - rows.T().front());
    const double ours = unit * dominant_frequency(lift, t[1] - t[0]);
    return {std::abs(deviation(ours, c.strouhal.value_or(0)))};
  });
  const auto mean_off = [&](const Series& values, const std::optional<double>& known) -> Reached {
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / values.size();
    return {std::abs(deviation(mean, known.value_or(0)))};
  };
  add(list, "mean_drag_max", c.mean_drag_max, [&] { return mean_off(drag, c.mean_drag); });
  add(list, "mean_lift_max", c.mean_lift_max, [&] { return mean_off(lift, c.mean_lift); });
}

}  // namespace vortree::checks
