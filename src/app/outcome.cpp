#include "app/outcome.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>

#include "exact/lamb_oseen.hpp"
#include "io/table.hpp"
#include "vortex/vorticity.hpp"

namespace vortree::app {
namespace {

constexpr double unseen = std::numeric_limits<double>::infinity();
using Column = std::vector<double>;
using Value = std::function<double(std::size_t row)>;

/// Cubic through the four nearest entries of a table; NaN outside it.
double interpolated(const Column& x, const Column& y, double at) {
  if (x.size() < 4 || at < x.front() - 1e-9 || at > x.back() + 1e-9)
    return std::numeric_limits<double>::quiet_NaN();
  const auto above = std::ranges::upper_bound(x, at) - x.begin();
  const auto first = std::clamp<std::ptrdiff_t>(above - 2, 0, std::ssize(x) - 4);
  double sum = 0;
  for (auto i = first; i < first + 4; ++i) {
    double weight = 1;
    for (auto k = first; k < first + 4; ++k)
      if (k != i) weight *= (at - x[k]) / (x[i] - x[k]);
    sum += weight * y[i];
  }
  return sum;
}

/// The rows of a report from a time T on.
class Rows {
 public:
  explicit Rows(const std::filesystem::path& file) : table_(file), T_(table_.column("T")) {}

  Column column(std::string_view name) const { return table_.column(name); }
  const Column& T() const { return T_; }

  double largest(std::optional<double> from, const Value& value) const {
    double most = -unseen;
    for (std::size_t r : rows(from)) most = std::max(most, std::abs(value(r)));
    return most < 0 ? unseen : most;
  }

  double rms(std::optional<double> from, const Value& value) const {
    double sum = 0;
    const auto which = rows(from);
    for (std::size_t r : which) sum += value(r) * value(r);
    return which.empty() ? unseen : std::sqrt(sum / static_cast<double>(which.size()));
  }

 private:
  std::vector<std::size_t> rows(std::optional<double> from) const {
    std::vector<std::size_t> result;
    for (std::size_t r = 0; r < T_.size(); ++r)
      if (T_[r] >= from.value_or(0) - 1e-9) result.push_back(r);
    return result;
  }

  io::Table table_;
  Column T_;
};

void add(std::vector<Verdict>& list, const char* what, std::optional<double> asked,
         const std::function<double()>& reached) {
  if (asked) list.push_back({what, *asked, reached()});
}

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

void check_forces(std::vector<Verdict>& list, const io::SceneCheck& c, const Rows& rows) {
  const Column impulse = rows.column("cd_impulse"), wall = rows.column("cd_wall"),
               lift = rows.column("cl_impulse"), wall_lift = rows.column("cl_wall");
  add(list, "routes_max", c.routes_max, [&] {
    return rows.largest(c.routes_from, [&](std::size_t r) { return impulse[r] / wall[r] - 1; });
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

/// The vortex at the end against the exact one, at points out to four cores in several directions.
void check_lamb_oseen(std::vector<Verdict>& list, const io::Scene& scene,
                      const vortex::Blobs& blobs, const FlowCase& flow, const Rows& rows) {
  const io::SceneCheck& c = scene.check;
  if (c.exact != io::ExactAnswer::lamb_oseen || !scene.initial || rows.T().empty()) return;
  const exact::LambOseen vortex{scene.initial->circulation, scene.initial->core, scene.flow.nu};
  const double t = rows.column("t").back();
  Column x, y, r, angle;
  for (int i = 0; i <= 80; ++i)
    for (int k = 0; k < 13; ++k) {
      r.push_back(0.05 * i * vortex.core_at(t));
      angle.push_back(0.3 + 2 * std::numbers::pi * k / 13);
      x.push_back(scene.initial->centre[0] + t * scene.flow.stream[0] +
                  r.back() * std::cos(angle.back()));
      y.push_back(scene.initial->centre[1] + t * scene.flow.stream[1] +
                  r.back() * std::sin(angle.back()));
    }
  Column omega(x.size());
  vortex::vorticity(blobs, nullptr, {x, y}, omega);
  const vortex::Velocities u = vortex::velocity_at({x, y}, blobs, flow.problem);
  double worst_vorticity = 0, worst_velocity = 0, fastest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double swirl = vortex.swirl(r[i], t);
    const double du = u.u[i] - scene.flow.stream[0] + swirl * std::sin(angle[i]);
    const double dv = u.v[i] - scene.flow.stream[1] - swirl * std::cos(angle[i]);
    worst_vorticity = std::max(worst_vorticity, std::abs(omega[i] - vortex.vorticity(r[i], t)));
    worst_velocity = std::max(worst_velocity, std::hypot(du, dv));
    fastest = std::max(fastest, std::abs(swirl));
  }
  add(list, "vorticity_max", c.vorticity_max,
      [&] { return worst_vorticity / std::abs(vortex.vorticity(0, t)); });
  add(list, "velocity_max", c.velocity_max, [&] { return worst_velocity / fastest; });
}

/// What free space keeps, from the first row of the report on.
void check_invariants(std::vector<Verdict>& list, const io::Scene& scene, const Rows& rows) {
  const io::SceneCheck& c = scene.check;
  const Column gamma = rows.column("circulation"), x = rows.column("impulse_x"),
               y = rows.column("impulse_y"), second = rows.column("second_moment"),
               t = rows.column("t");
  const double length = scene.initial ? scene.initial->core : 1;
  const double unit = gamma.empty() || gamma[0] == 0 ? 1 : std::abs(gamma[0]);
  add(list, "circulation_max", c.circulation_max, [&] {
    return rows.largest({}, [&](std::size_t r) { return (gamma[r] - gamma[0]) / unit; });
  });
  add(list, "impulse_max", c.impulse_max, [&] {
    return rows.largest(
        {}, [&](std::size_t r) { return std::hypot(x[r] - x[0], y[r] - y[0]) / (unit * length); });
  });
  add(list, "second_moment_max", c.second_moment_max, [&] {
    return rows.largest({}, [&](std::size_t r) {
      return (second[r] - second[0] - 4 * scene.flow.nu * gamma[0] * (t[r] - t[0])) / second[0];
    });
  });
}

}  // namespace

std::vector<Verdict> verdicts(const io::Scene& scene, const std::filesystem::path& folder,
                              const vortex::Blobs& blobs, const FlowCase& flow) {
  std::vector<Verdict> list;
  const Rows rows(folder / "report.csv");
  if (flow.wall) {
    check_drag(list, scene, rows);
    check_forces(list, scene.check, rows);
    check_wall(list, scene, folder, flow);
  }
  check_lamb_oseen(list, scene, blobs, flow, rows);
  check_invariants(list, scene, rows);
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
