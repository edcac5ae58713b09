#include "checks/checks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "checks/free_space.hpp"
#include "checks/history_rows.hpp"
#include "checks/periodogram.hpp"
#include "checks/plunge.hpp"
#include "checks/spin.hpp"
#include "io/tables/table.hpp"

namespace vortree::checks {
namespace {

/// A column of a reference between its entries; none outside them, and where cells are empty.
class Known {
 public:
  Known(const io::Table& reference, const char* column)
      : T_(reference.column("T")), values_(reference.column(column)) {}

  std::optional<double> at(double T) const {
    const auto value = interpolated(T_, values_, T);
    return value && std::isnan(*value) ? std::nullopt : value;
  }

 private:
  Column T_, values_;
};

/// How far a column of the report is off what is known, row by row.
Value off(const HistoryRows& rows, const char* column, Known known,
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

void check_drag(std::vector<Verdict>& list, const io::Scene& scene, const HistoryRows& rows) {
  const io::CheckSettings& c = scene.check;
  if (!c.drag_reference) return;
  const io::Table reference(io::reference_path(scene, *c.drag_reference));
  const Value drag = off(rows, "cd_impulse", {reference, "C_D"}, deviation);
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

/// A wake that sheds: its frequency, and its mean drag and lift.
void check_shedding(std::vector<Verdict>& list, const io::CheckSettings& c,
                    const HistoryRows& rows) {
  constexpr std::size_t least = 100;  // rows
  const Column t = rows.column("t"), all_lift = rows.column("cl_impulse"),
               all_drag = rows.column("cd_impulse");
  const auto first = static_cast<std::ptrdiff_t>(
      std::ranges::lower_bound(rows.T(), c.shedding_from.value_or(0)) - rows.T().begin());
  const Column lift(all_lift.begin() + first, all_lift.end()),
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
  const auto mean_off = [&](const Column& values, const std::optional<double>& known) -> Reached {
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / values.size();
    return {std::abs(deviation(mean, known.value_or(0)))};
  };
  add(list, "mean_drag_max", c.mean_drag_max, [&] { return mean_off(drag, c.mean_drag); });
  add(list, "mean_lift_max", c.mean_lift_max, [&] { return mean_off(lift, c.mean_lift); });
}

/// One route to a force against the other, as a share of the largest force.
Reached routes_apart(const HistoryRows& rows, std::optional<double> from, const Column& a,
                     const Column& b) {
  const Reached most = rows.largest(from, [&](std::size_t r) { return a[r]; });
  const Reached apart = rows.largest(from, [&](std::size_t r) { return a[r] - b[r]; });
  if (!most.value) return most;
  return {share(*apart.value, *most.value)};
}

void check_forces(std::vector<Verdict>& list, const io::Scene& scene, const HistoryRows& rows) {
  const io::CheckSettings& c = scene.check;
  const Column impulse = rows.column("cd_impulse"), wall = rows.column("cd_wall"),
               lift = rows.column("cl_impulse"), wall_lift = rows.column("cl_wall");
  add(list, "routes_max", c.routes_max, [&] {
    if (scene.plunge) return routes_apart(rows, c.routes_from, impulse, wall);
    return rows.largest(c.routes_from,
                        [&](std::size_t r) { return deviation(impulse[r], wall[r]); });
  });
  add(list, "lift_routes_max", c.lift_routes_max,
      [&] { return routes_apart(rows, c.routes_from, lift, wall_lift); });
  add(list, "lift_max", c.lift_max, [&] {
    return rows.largest({}, [&](std::size_t r) { return largest_of({lift[r], wall_lift[r]}); });
  });
}

/// The time among those of wall.csv that is next to T, if one is within 0.02.
std::optional<double> frame_at(const Column& times, double T) {
  if (times.empty()) return std::nullopt;
  const double next =
      *std::ranges::min_element(times, {}, [&](double time) { return std::abs(time - T); });
  return std::abs(next - T) < 0.02 ? std::optional(next) : std::nullopt;
}

/// Relative L2 deviation of the wall vorticity, omega R/U, at the times that wall.csv and the
/// reference share.
Column wall_deviations(const io::Scene& scene, const std::filesystem::path& folder,
                       const flow::Scales& scales) {
  const io::Table reference(io::reference_path(scene, *scene.check.wall_vorticity_reference));
  const io::Table wall(folder / "wall.csv");
  const Column rT = reference.column("T"), rAngle = reference.column("theta_deg"),
               rValue = reference.column("omega_R_over_U");
  const Column T = wall.column("T"), angle = wall.column("angle_deg"),
               value = wall.column("vorticity");
  const double unit = scales.length / (2 * scales.speed);
  Column deviations;
  for (std::size_t k = 0; k < rT.size();) {
    const double time = rT[k];
    const auto frame = frame_at(T, time);
    Column x, y;
    for (std::size_t i = 0; frame && i < T.size(); ++i)
      if (T[i] == *frame && angle[i] >= 0) {
        x.push_back(angle[i]);
        y.push_back(unit * value[i]);
      }
    double off = 0, size = 0;
    for (; k < rT.size() && rT[k] == time; ++k)
      if (const auto ours = interpolated(x, y, rAngle[k])) {
        off += std::pow(*ours - rValue[k], 2);
        size += rValue[k] * rValue[k];
      }
    if (size > 0 && time >= scene.check.wall_vorticity_from.value_or(0))
      deviations.push_back(std::sqrt(off / size));
  }
  return deviations;
}

void check_wall(std::vector<Verdict>& list, const io::Scene& scene,
                const std::filesystem::path& folder, const flow::Scales& scales,
                const HistoryRows& rows) {
  const io::CheckSettings& c = scene.check;
  if (!c.wall_vorticity_reference) return;
  const Column off = wall_deviations(scene, folder, scales);
  const auto reached = [&](double number) -> Reached {
    if (!off.empty()) return {number};
    if (rows.T().empty() || rows.T().back() < c.wall_vorticity_from.value_or(0))
      return rows.too_short();
    return {.value = {}, .why = "no frame within 0.02 of a time T of the reference"};
  };
  add(list, "wall_vorticity_max", c.wall_vorticity_max, [&] { return reached(largest_of(off)); });
  add(list, "wall_vorticity_rms", c.wall_vorticity_rms, [&] {
    double sum = 0;
    for (double d : off) sum += d * d;
    return reached(std::sqrt(sum / static_cast<double>(off.size())));
  });
}

}  // namespace

std::vector<Verdict> verdicts(const io::Scene& scene, const std::filesystem::path& folder,
                              const flow::Solver& solver, const flow::Scales& scales) {
  std::vector<Verdict> list;
  const HistoryRows rows(folder / "report.csv");
  if (scales.body) {
    check_drag(list, scene, rows);
    check_forces(list, scene, rows);
    check_shedding(list, scene.check, rows);
    check_plunge(list, scene, scales, rows);
    check_spin(list, scene, solver);
    check_wall(list, scene, folder, scales, rows);
  }
  check_free_space(list, scene, folder, solver, scales, rows);
  add(list, "blobs_max", scene.check.blobs_max, [&, count = rows.column(solver.particle() + "s")] {
    return rows.largest({}, [&](std::size_t r) { return count[r]; });
  });
  return list;
}

namespace {

std::string text(const Verdict& v) {
  if (!std::isfinite(*v.reached.value)) return fmt::format("{} is not finite (missed)", v.what);
  return fmt::format("{} {:.3g} of {:.3g}{}", v.what, *v.reached.value, v.asked,
                     v.missed() ? " (missed)" : "");
}

/// `a, b (the run ends at T = 1)`, one after the other for each reason.
std::string not_reached(std::span<const Verdict> verdicts) {
  std::vector<std::string> whys, names;
  for (const Verdict& v : verdicts) {
    if (v.reached.value) continue;
    const auto known = std::ranges::find(whys, v.reached.why) - whys.begin();
    if (known == std::ssize(whys)) {
      whys.push_back(v.reached.why);
      names.push_back(v.what);
    } else {
      names[static_cast<std::size_t>(known)] += ", " + v.what;
    }
  }
  for (std::size_t k = 0; k < whys.size(); ++k) names[k] += fmt::format(" ({})", whys[k]);
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

std::string verdict_line(std::span<const Verdict> verdicts) {
  if (verdicts.empty()) return "nothing to check";
  std::vector<std::string> words;
  for (const Verdict& v : verdicts)
    if (v.reached.value) words.push_back(text(v));
  const std::string missing = not_reached(verdicts);
  if (words.empty()) return "nothing of the check was reached: " + missing;
  const bool missed = std::ranges::any_of(verdicts, &Verdict::missed);
  return fmt::format("check {}: {}{}{}", missed ? "FAILED" : "passed", fmt::join(words, ", "),
                     missing.empty() ? "" : "; not reached: ", missing);
}

}  // namespace vortree::checks
