#include "app/outcome.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>

#include "app/free_space_checks.hpp"
#include "app/plunge_checks.hpp"
#include "app/rows.hpp"
#include "bench/periodogram.hpp"
#include "io/table.hpp"

namespace vortree::app {
namespace {

void check_drag(std::vector<Verdict>& list, const io::Scene& scene, const Rows& rows) {
  const io::SceneCheck& c = scene.check;
  if (!c.drag_reference) return;
  const io::Table reference(io::reference_path(scene, *c.drag_reference));
  const Column T = reference.column("T"), drag = reference.column("C_D");
  const Column ours = rows.column("cd_impulse");
  const Value deviation = [&](std::size_t r) {
    return ours[r] / interpolated(T, drag, rows.T()[r]) - 1;
  };
  add(list, "drag_max", c.drag_max, [&] { return rows.largest(c.drag_from, deviation); });
  add(list, "drag_rms", c.drag_rms, [&] { return rows.rms(c.drag_from, deviation); });
  if (c.bubble_max) {
    const Column length = reference.column("L_over_D"), bubble = rows.column("bubble_length");
    add(list, "bubble_max", c.bubble_max, [&] {
      return rows.largest(c.bubble_from, [&](std::size_t r) {
        return bubble[r] / interpolated(T, length, rows.T()[r]) - 1;
      });
    });
  }
  if (c.separation_max_deg) {
    const Column angle = reference.column("sep_deg"), separation = rows.column("separation_deg");
    add(list, "separation_max_deg", c.separation_max_deg, [&] {
      return rows.largest(c.separation_from, [&](std::size_t r) {
        return separation[r] - interpolated(T, angle, rows.T()[r]);
      });
    });
  }
}

/// A wake that sheds: its frequency, and its mean drag and lift.
void check_shedding(std::vector<Verdict>& list, const io::SceneCheck& c, const Rows& rows) {
  Column lift, drag;
  const Column all_lift = rows.column("cl_impulse"), all_drag = rows.column("cd_impulse"),
               t = rows.column("t");
  for (std::size_t r = 0; r < rows.T().size(); ++r)
    if (rows.T()[r] >= c.shedding_from.value_or(0)) {
      lift.push_back(all_lift[r]);
      drag.push_back(all_drag[r]);
    }
  const bool enough = lift.size() >= 100;
  add(list, "strouhal_max", c.strouhal_max, [&] {
    if (!enough || !c.strouhal) return unseen;
    // T runs 2 U/D times as fast as t: frequency times D/U.
    const double unit = 2 * (t.back() - t.front()) / (rows.T().back() - rows.T().front());
    return std::abs(unit * bench::dominant_frequency(lift, t[1] - t[0]) / *c.strouhal - 1);
  });
  const auto mean_off = [&](const Column& values, const std::optional<double>& known) {
    if (!enough || !known) return unseen;
    return std::abs(std::accumulate(values.begin(), values.end(), 0.0) / values.size() / *known -
                    1);
  };
  add(list, "mean_drag_max", c.mean_drag_max, [&] { return mean_off(drag, c.mean_drag); });
  add(list, "mean_lift_max", c.mean_lift_max, [&] { return mean_off(lift, c.mean_lift); });
}

void check_forces(std::vector<Verdict>& list, const io::Scene& scene, const Rows& rows) {
  const io::SceneCheck& c = scene.check;
  const Column impulse = rows.column("cd_impulse"), wall = rows.column("cd_wall"),
               lift = rows.column("cl_impulse"), wall_lift = rows.column("cl_wall");
  add(list, "routes_max", c.routes_max, [&] {
    if (!scene.plunge)
      return rows.largest(c.routes_from, [&](std::size_t r) { return impulse[r] / wall[r] - 1; });
    const double most = rows.largest(c.routes_from, [&](std::size_t r) { return impulse[r]; });
    return rows.largest(c.routes_from, [&](std::size_t r) { return impulse[r] - wall[r]; }) / most;
  });
  add(list, "lift_routes_max", c.lift_routes_max, [&] {
    const double most = rows.largest(c.routes_from, [&](std::size_t r) { return lift[r]; });
    return rows.largest(c.routes_from, [&](std::size_t r) { return lift[r] - wall_lift[r]; }) /
           most;
  });
  add(list, "lift_max", c.lift_max, [&] {
    return rows.largest(
        {}, [&](std::size_t r) { return std::max(std::abs(lift[r]), std::abs(wall_lift[r])); });
  });
}

/// Relative L2 deviation of the wall vorticity, omega R/U, at the times that wall.csv and the
/// reference share (within 0.02 in T): the largest, or the root of the mean square over the times.
std::vector<double> wall_deviations(const io::Scene& scene, const std::filesystem::path& folder,
                                    const FlowCase& flow) {
  const io::Table reference(io::reference_path(scene, *scene.check.wall_vorticity_reference));
  const io::Table wall(folder / "wall.csv");
  const Column rT = reference.column("T"), rAngle = reference.column("theta_deg"),
               rValue = reference.column("omega_R_over_U");
  const Column T = wall.column("T"), angle = wall.column("angle_deg"),
               value = wall.column("vorticity");
  const double unit = flow.diameter / (2 * flow.speed);
  std::vector<double> deviations;
  for (std::size_t k = 0; k < rT.size();) {
    const double time = rT[k];
    Column x, y;
    for (std::size_t i = 0; i < T.size(); ++i)
      if (std::abs(T[i] - time) < 0.02 && angle[i] >= 0) {
        x.push_back(angle[i]);
        y.push_back(unit * value[i]);
      }
    double off = 0, size = 0;
    for (; k < rT.size() && rT[k] == time; ++k) {
      if (x.empty() || rAngle[k] < x.front() || rAngle[k] > x.back()) continue;
      off += std::pow(interpolated(x, y, rAngle[k]) - rValue[k], 2);
      size += rValue[k] * rValue[k];
    }
    if (size > 0 && time >= scene.check.wall_vorticity_from.value_or(0))
      deviations.push_back(std::sqrt(off / size));
  }
  return deviations;
}

void check_wall(std::vector<Verdict>& list, const io::Scene& scene,
                const std::filesystem::path& folder, const FlowCase& flow) {
  const io::SceneCheck& c = scene.check;
  if (!c.wall_vorticity_reference) return;
  const std::vector<double> off = wall_deviations(scene, folder, flow);
  add(list, "wall_vorticity_max", c.wall_vorticity_max,
      [&] { return off.empty() ? unseen : std::ranges::max(off); });
  add(list, "wall_vorticity_rms", c.wall_vorticity_rms, [&] {
    double sum = 0;
    for (double d : off) sum += d * d;
    return off.empty() ? unseen : std::sqrt(sum / static_cast<double>(off.size()));
  });
}

}  // namespace

std::vector<Verdict> verdicts(const io::Scene& scene, const std::filesystem::path& folder,
                              const vortex::Blobs& blobs, const FlowCase& flow) {
  std::vector<Verdict> list;
  const Rows rows(folder / "report.csv");
  if (flow.wall) {
    check_drag(list, scene, rows);
    check_forces(list, scene, rows);
    check_shedding(list, scene.check, rows);
    check_plunge(list, scene, flow, rows);
    check_wall(list, scene, folder, flow);
  }
  check_free_space(list, scene, folder, blobs, flow, rows);
  const Column count = rows.column("blobs");
  add(list, "blobs_max", scene.check.blobs_max,
      [&] { return rows.largest({}, [&](std::size_t r) { return count[r]; }); });
  return list;
}

std::string verdict_line(std::span<const Verdict> verdicts) {
  if (verdicts.empty()) return "nothing to check";
  const bool passed = std::ranges::all_of(verdicts, &Verdict::passed);
  std::string line = passed ? "check passed:" : "check FAILED:";
  for (const Verdict& v : verdicts)
    line += fmt::format("{} {} {:.3g} of {:.3g}{}", &v == verdicts.data() ? "" : ",", v.what,
                        v.reached, v.asked, v.passed() ? "" : " (missed)");
  return line;
}

}  // namespace vortree::app
