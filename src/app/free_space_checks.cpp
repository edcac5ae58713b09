#include "app/free_space_checks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exact/kirchhoff_ellipse.hpp"
#include "exact/lamb_oseen.hpp"
#include "exact/vortex_pairs.hpp"
#include "vortex/vorticity.hpp"

namespace vortree::app {
namespace {

/// The vortex at the end, as seen from the flow's origin, against the exact one, at points out to
/// four cores in several directions.
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
      x.push_back(r.back() * std::cos(angle.back()));
      y.push_back(r.back() * std::sin(angle.back()));
    }
  Column omega(x.size());
  vortex::vorticity(blobs, nullptr, {x, y}, omega);
  const vortex::Velocities u = vortex::velocity_at({x, y}, blobs, flow.problem);
  double worst_vorticity = 0, worst_velocity = 0, fastest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double swirl = vortex.swirl(r[i], t);
    const double du = u.u[i] + swirl * std::sin(angle[i]);
    const double dv = u.v[i] - swirl * std::cos(angle[i]);
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
  const Column plus = rows.column("circulation_plus");
  double unit = gamma.empty() ? 0 : std::max(std::abs(gamma[0]), plus[0]);
  if (unit == 0) unit = 1;
  // What the stream carries along has the more impulse about the scene's origin.
  const auto carried = [&](std::size_t r) {
    const auto [u, v] = scene.flow.stream;
    return (gamma[0] * (t[r] - t[0])) * vortex::Vec2{v, -u};
  };
  add(list, "circulation_max", c.circulation_max, [&] {
    return rows.largest({}, [&](std::size_t r) { return (gamma[r] - gamma[0]) / unit; });
  });
  add(list, "impulse_max", c.impulse_max, [&] {
    return rows.largest({}, [&](std::size_t r) {
      return std::hypot(x[r] - x[0] - carried(r).x, y[r] - y[0] - carried(r).y) / (unit * length);
    });
  });
  add(list, "second_moment_max", c.second_moment_max, [&] {
    return rows.largest({}, [&](std::size_t r) {
      return (second[r] - second[0] - 4 * scene.flow.nu * gamma[0] * (t[r] - t[0])) / second[0];
    });
  });
}

/// How far the major axis has turned since the start, at each row [rad].
Column turned(const Rows& rows) {
  const Column xx = rows.column("quadrupole_xx"), xy = rows.column("quadrupole_xy");
  Column angle(xx.size());
  for (std::size_t r = 1; r < angle.size(); ++r)  // less than a quarter turn a step
    angle[r] = angle[r - 1] + 0.5 * std::atan2(xx[r - 1] * xy[r] - xy[r - 1] * xx[r],
                                               xx[r - 1] * xx[r] + xy[r - 1] * xy[r]);
  return angle;
}

void check_kirchhoff(std::vector<Verdict>& list, const io::Scene& scene, const Rows& rows) {
  const io::SceneInitial& i = *scene.initial;
  const exact::KirchhoffEllipse ellipse{i.circulation, i.core, *i.core_across};
  add(list, "rotation_max", scene.check.rotation_max, [&] {
    const Column angle = turned(rows), t = rows.column("t");
    return angle.size() < 2
               ? unseen
               : std::abs(angle.back() / (ellipse.rate() * (t.back() - t.front())) - 1);
  });
}

exact::VortexPair pair_of(const io::Scene& scene) {
  const io::SceneInitial& i = *scene.initial;
  return {i.circulation, i.core, *i.separation, scene.flow.nu};
}

/// The core, as it spreads alone, over the separation when that has first fallen by a hundredth.
void check_merger(std::vector<Verdict>& list, const io::Scene& scene, const Rows& rows) {
  const Column t = rows.column("t"), apart = rows.column("separation");
  add(list, "merger_max", scene.check.merger_max, [&] {
    const auto fallen = std::ranges::find_if(apart, [&](double b) { return b < 0.99 * apart[0]; });
    if (fallen == apart.end()) return unseen;
    const std::size_t r = fallen - apart.begin();
    return std::abs(pair_of(scene).core_at(t[r]) / apart[r] - exact::VortexPair::onset);
  });
}

void check_dipole(std::vector<Verdict>& list, const io::Scene& scene, const Rows& rows) {
  const Column t = rows.column("t"), x = rows.column("plus_x"), y = rows.column("plus_y");
  add(list, "speed_max", scene.check.speed_max, [&] {
    if (t.size() < 2) return unseen;
    const double way = std::hypot(x.back() - x[0], y.back() - y[0]);
    return std::abs(way / std::abs(pair_of(scene).travelled(t.back())) - 1);
  });
}

/// Quadrupole and separation at the times of a reference.
void check_moments(std::vector<Verdict>& list, const io::Scene& scene, const Rows& rows) {
  const io::SceneCheck& c = scene.check;
  if (!c.moments_reference) return;
  const io::Table reference(io::reference_path(scene, *c.moments_reference));
  const Column t = reference.column("t"), ours = rows.column("t");
  const auto off = [&](const char* name, std::size_t row) {
    const Column column = reference.column(name);
    return interpolated(ours, rows.column(name), t[row]) - column[row];
  };
  const auto largest = [&](const auto& deviation, const Column& scale) {
    double worst = 0, size = 0;
    for (std::size_t row = 0; row < t.size() && t[row] <= ours.back() + 1e-9; ++row) {
      worst = std::max(worst, deviation(row));
      size = std::max(size, std::abs(scale[row]));
    }
    return size > 0 ? worst / size : unseen;
  };
  add(list, "quadrupole_max", c.quadrupole_max, [&] {
    return largest(
        [&](std::size_t r) { return std::hypot(off("quadrupole_xx", r), off("quadrupole_xy", r)); },
        reference.column("quadrupole_xx"));
  });
  add(list, "separation_max", c.separation_max, [&] {
    return largest([&](std::size_t r) { return std::abs(off("separation", r)); },
                   reference.column("separation"));
  });
}

/// What the energy differs from that at the start less what viscosity has taken (trapezoid rule
/// over the times of the frames).
void check_energy(std::vector<Verdict>& list, const io::Scene& scene,
                  const std::filesystem::path& folder) {
  add(list, "energy_max", scene.check.energy_max, [&] {
    const io::Table table(folder / "energy.csv");
    const Column t = table.column("t"), e = table.column("energy"), z = table.column("enstrophy");
    if (t.size() < 2) return unseen;
    double taken = 0, worst = 0;
    for (std::size_t r = 1; r < t.size(); ++r) {
      taken += scene.flow.nu * (t[r] - t[r - 1]) * (z[r] + z[r - 1]) / 2;
      worst = std::max(worst, std::abs((e[r] - e[0] + taken) / e[0]));
    }
    return worst;
  });
}

}  // namespace

void check_free_space(std::vector<Verdict>& list, const io::Scene& scene,
                      const std::filesystem::path& folder, const vortex::Blobs& blobs,
                      const FlowCase& flow, const Rows& rows) {
  check_lamb_oseen(list, scene, blobs, flow, rows);
  if (scene.check.exact == io::ExactAnswer::kirchhoff_ellipse) check_kirchhoff(list, scene, rows);
  if (scene.check.exact == io::ExactAnswer::corotating_pair) check_merger(list, scene, rows);
  if (scene.check.exact == io::ExactAnswer::dipole) check_dipole(list, scene, rows);
  check_moments(list, scene, rows);
  check_energy(list, scene, folder);
  check_invariants(list, scene, rows);
}

}  // namespace vortree::app
