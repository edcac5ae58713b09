#include "checks/periodic_flow.hpp"

#include <cmath>

namespace vortree::checks {
namespace {

Reached last(const HistoryRows& rows, const char* column) {
  const Series values = rows.column(column);
  return values.empty() ? rows.too_short() : Reached{values.back()};
}

}  // namespace

void check_periodic_flow(std::vector<Verdict>& list, const Finished& run) {
  const io::CheckSettings& c = run.scene.check;
  const HistoryRows& rows = run.rows;
  add(list, "velocity_rms", c.velocity_rms, [&] { return last(rows, "velocity_error"); });
  add(list, "pressure_rms", c.pressure_rms, [&] { return last(rows, "pressure_error"); });
  add(list, "volume_max", c.volume_max, [&] {
    const Series volume = rows.column("volume");
    return rows.largest({}, [&](std::size_t r) { return volume[r] - 1; });
  });
  add(list, "momentum_max", c.momentum_max, [&] {
    const Series x = rows.column("momentum_x"), y = rows.column("momentum_y");
    return rows.largest({}, [&](std::size_t r) { return std::hypot(x[r], y[r]); });
  });
}

}  // namespace vortree::checks
