#include "checks/forces.hpp"

#include <cmath>
#include <optional>
#include <string>

#include "exact/cylinder_drag.hpp"
#include "io/scene/reference.hpp"
#include "io/tables/table.hpp"

namespace vortree::checks {
namespace {

/// A column of a reference between its entries; none outside them, and where cells are empty.
class ReferenceCurve {
 public:
  ReferenceCurve(const io::Table& reference, const char* column)
      : T_(reference.column("T")), values_(reference.column(column)) {}

  std::optional<double> at(double T) const {
    const auto value = interpolated(T_, values_, T);
    return value && std::isnan(*value) ? std::nullopt : value;
  }

 private:
  Series T_, values_;
};

/// How far a column of the report is off what is known, row by row.
Deviation off(const HistoryRows& rows, const std::string& column, ReferenceCurve known,
              double (*distance)(double, double)) {
  return [&rows, ours = rows.column(column), known = std::move(known),
          distance](std::size_t r) -> std::optional<double> {
    const auto value = known.at(rows.T()[r]);
    return value ? std::optional(distance(ours[r], *value)) : std::nullopt;
  };
}

double difference(double ours, double known) {
  return ours - known;
}

/// One route to a force against the other, as a share of the largest force.
Reached routes_apart(const HistoryRows& rows, std::optional<double> from, const Series& a,
                     const Series& b) {
  const Reached most = rows.largest(from, [&](std::size_t r) { return a[r]; });
  const Reached apart = rows.largest(from, [&](std::size_t r) { return a[r] - b[r]; });
  if (!most.value) return most;
  return {share(*apart.value, *most.value)};
}

/// A lift may pass through zero, so that what it is off is a share of the largest that is known.
Deviation lift_off(const Finished& run, std::optional<double> from, const ReferenceCurve& known) {
  const Reached most =
      run.rows.largest(from, [&](std::size_t r) { return known.at(run.rows.T()[r]); });
  const double whole = most.value.value_or(0);
  return [off = off(run.rows, "cl_" + run.solver.route(), known, difference),
          whole](std::size_t r) -> std::optional<double> {
    const auto apart = off(r);
    return apart ? std::optional(share(*apart, whole)) : std::nullopt;
  };
}

std::string drag_of(const Finished& run) {
  return "cd_" + run.solver.route();
}

/// Means, as the drag of a step jumps where blobs of one release all split.
Reached early_drag_off(const Finished& run) {
  constexpr double end = 0.1 + 1e-9;
  const Series &T = run.rows.T(), drag = run.rows.column(drag_of(run));
  if (T.empty() || T.back() < 0.1 - 1e-9) return run.rows.too_short();
  const double reynolds = run.scales.speed * (run.scales.length / 2) / run.scene.flow.nu;
  double ours = 0, exact = 0;
  for (std::size_t r = 0; r < T.size() && T[r] < end; ++r)
    ours += drag[r], exact += exact::short_time_cylinder_drag(reynolds, T[r]);
  if (exact == 0) return {.value = {}, .why = "the first step ends after T = 0.1"};
  return {std::abs(deviation(ours, exact))};
}

void add_without_reference(std::vector<Verdict>& list, const io::CheckSettings& c) {
  add(list, "drag_max", c.drag_max, without_reference);
  add(list, "drag_rms", c.drag_rms, without_reference);
  add(list, "bubble_max", c.bubble_max, without_reference);
  add(list, "separation_max_deg", c.separation_max_deg, without_reference);
}

}  // namespace

void check_drag(std::vector<Verdict>& list, const Finished& run) {
  const io::Scene& scene = run.scene;
  const HistoryRows& rows = run.rows;
  const io::CheckSettings& c = scene.check;
  if (!run.scales.body || !c.drag_reference) return;
  if (io::lacks_reference(scene, *c.drag_reference)) return add_without_reference(list, c);
  const io::Table reference(io::reference_path(scene, *c.drag_reference));
  const Deviation drag = off(rows, drag_of(run), {reference, "C_D"}, deviation);
  add(list, "drag_max", c.drag_max, [&] { return rows.largest(c.drag_from, drag); });
  add(list, "drag_rms", c.drag_rms, [&] { return rows.rms(c.drag_from, drag); });
  add(list, "bubble_max", c.bubble_max, [&] {
    return rows.largest(c.bubble_from,
                        off(rows, "bubble_length", {reference, "L_over_D"}, deviation));
  });
  add(list, "separation_max_deg", c.separation_max_deg, [&] {
    return rows.largest(c.separation_from,
                        off(rows, "separation_deg", {reference, "sep_deg"}, difference));
  });
}

void check_lift(std::vector<Verdict>& list, const Finished& run) {
  const io::CheckSettings& c = run.scene.check;
  if (!run.scales.body || !c.lift_reference) return;
  if (io::lacks_reference(run.scene, *c.lift_reference)) {
    add(list, "lift_error_max", c.lift_error_max, without_reference);
    return add(list, "lift_error_rms", c.lift_error_rms, without_reference);
  }
  const io::Table reference(io::reference_path(run.scene, *c.lift_reference));
  const Deviation lift = lift_off(run, c.lift_from, {reference, "C_L"});
  add(list, "lift_error_max", c.lift_error_max,
      [&] { return run.rows.largest(c.lift_from, lift); });
  add(list, "lift_error_rms", c.lift_error_rms, [&] { return run.rows.rms(c.lift_from, lift); });
}

void check_early_drag(std::vector<Verdict>& list, const Finished& run) {
  add(list, "early_drag_max", run.scene.check.early_drag_max, [&] { return early_drag_off(run); });
}

void check_forces(std::vector<Verdict>& list, const Finished& run) {
  if (!run.scales.body) return;
  const io::Scene& scene = run.scene;
  const HistoryRows& rows = run.rows;
  const io::CheckSettings& c = scene.check;
  const Series impulse = rows.column("cd_impulse"), wall = rows.column("cd_wall"),
               lift = rows.column("cl_impulse"), wall_lift = rows.column("cl_wall");
  add(list, "routes_max", c.routes_max, [&] {
    if (scene.plunge || scene.motion) return routes_apart(rows, c.routes_from, impulse, wall);
    return rows.largest(c.routes_from,
                        [&](std::size_t r) { return deviation(impulse[r], wall[r]); });
  });
  add(list, "lift_routes_max", c.lift_routes_max,
      [&] { return routes_apart(rows, c.routes_from, lift, wall_lift); });
  add(list, "lift_max", c.lift_max, [&] {
    return rows.largest({}, [&](std::size_t r) { return largest_of({lift[r], wall_lift[r]}); });
  });
}

}  // namespace vortree::checks
