#include "checks/free_space.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exact/kirchhoff_ellipse.hpp"
#include "exact/lamb_oseen.hpp"
#include "exact/vortex_pairs.hpp"
#include "io/scene/reference.hpp"

namespace vortree::checks {

/// The vortex at the end against the exact one, which goes with the stream, at points out to four
/// cores in several directions.
void check_lamb_oseen(std::vector<Verdict>& list, const Finished& run) {
  const io::Scene& scene = run.scene;
  const HistoryRows& rows = run.rows;
  const io::CheckSettings& c = scene.check;
  if (c.exact != io::ExactAnswer::lamb_oseen || !scene.initial || rows.T().empty()) return;
  const exact::LambOseen vortex{*scene.initial->circulation, *scene.initial->core, scene.flow.nu};
  const double t = rows.column("t").back();
  const auto [u0, v0] = scene.flow.stream;
  const Vec2 centre{scene.initial->centre[0] + t * u0, scene.initial->centre[1] + t * v0};
  Series x, y, r, angle;
  for (int i = 0; i <= 80; ++i)
    for (int k = 0; k < 13; ++k) {
      r.push_back(0.05 * i * vortex.core_at(t));
      angle.push_back(0.3 + 2 * std::numbers::pi * k / 13);
      x.push_back(centre.x + r.back() * std::cos(angle.back()));
      y.push_back(centre.y + r.back() * std::sin(angle.back()));
    }
  const flow::Samples found = run.solver.sample({x, y});
  Series vorticity_off, velocity_off;
  double fastest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double swirl = vortex.swirl(r[i], t);
    const double du = found.u[i] - u0 + swirl * std::sin(angle[i]);
    const double dv = found.v[i] - v0 - swirl * std::cos(angle[i]);
    vorticity_off.push_back(found.omega[i] - vortex.vorticity(r[i], t));
    velocity_off.push_back(std::hypot(du, dv));
    fastest = std::max(fastest, std::abs(swirl));
  }
  add(list, "vorticity_max", c.vorticity_max,
      [&] { return Reached{share(largest_of(vorticity_off), std::abs(vortex.vorticity(0, t)))}; });
  add(list, "velocity_max", c.velocity_max,
      [&] { return Reached{share(largest_of(velocity_off), fastest)}; });
}

/// What free space keeps, from the first row of the report on.
void check_invariants(std::vector<Verdict>& list, const Finished& run) {
  const io::Scene& scene = run.scene;
  const flow::Scales& scales = run.scales;
  const HistoryRows& rows = run.rows;
  const io::CheckSettings& c = scene.check;
  if (!c.circulation_max && !c.impulse_max && !c.second_moment_max) return;
  const Series gamma = rows.column("circulation"), x = rows.column("impulse_x"),
               y = rows.column("impulse_y"), second = rows.column("second_moment"),
               t = rows.column("t");
  const double length = scales.body ? scales.length : scene.initial ? *scene.initial->core : 1;
  // Of opposite vortices, that of one sign; known to who has no body.
  double unit = scales.body ? scales.speed * scales.length
                            : std::max(std::abs(gamma[0]), rows.column("circulation_plus")[0]);
  if (unit == 0) unit = 1;
  // Opposite vortices have none but what rounding leaves.
  const double least = unit * length * length;
  const double of_second = std::abs(second[0]) > 1e-9 * least ? std::abs(second[0]) : least;
  // What the stream carries along has the more impulse about the scene's origin.
  const auto carried = [&](std::size_t r) {
    const auto [u, v] = scene.flow.stream;
    return (gamma[0] * (t[r] - t[0])) * Vec2{v, -u};
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
      return (second[r] - second[0] - 4 * scene.flow.nu * gamma[0] * (t[r] - t[0])) / of_second;
    });
  });
}

namespace {

/// How far the major axis has turned since the start, at each row [rad].
Series turned(const HistoryRows& rows) {
  const Series xx = rows.column("quadrupole_xx"), xy = rows.column("quadrupole_xy");
  Series angle(xx.size());
  for (std::size_t r = 1; r < angle.size(); ++r)  // less than a quarter turn a step
    angle[r] = angle[r - 1] + 0.5 * std::atan2(xx[r - 1] * xy[r] - xy[r - 1] * xx[r],
                                               xx[r - 1] * xx[r] + xy[r - 1] * xy[r]);
  return angle;
}

}  // namespace

void check_kirchhoff(std::vector<Verdict>& list, const Finished& run) {
  const io::Scene& scene = run.scene;
  if (scene.check.exact != io::ExactAnswer::kirchhoff_ellipse) return;
  const HistoryRows& rows = run.rows;
  const flow::InitialSettings& i = *scene.initial;
  const exact::KirchhoffEllipse ellipse{*i.circulation, *i.core, i.number("core_across")};
  add(list, "rotation_max", scene.check.rotation_max, [&]() -> Reached {
    const Series angle = turned(rows), t = rows.column("t");
    if (angle.size() < 2) return rows.too_short();
    return {std::abs(deviation(angle.back(), ellipse.rate() * (t.back() - t.front())))};
  });
}

namespace {

exact::VortexPair pair_of(const io::Scene& scene) {
  const flow::InitialSettings& i = *scene.initial;
  return {*i.circulation, *i.core, i.number("separation"), scene.flow.nu};
}

}  // namespace

/// The core, as it spreads alone, over the separation when that has first fallen by a hundredth.
/// Vortices that stay apart have missed it when that is past what was asked.
void check_merger(std::vector<Verdict>& list, const Finished& run) {
  const io::Scene& scene = run.scene;
  if (scene.check.exact != io::ExactAnswer::corotating_pair) return;
  const HistoryRows& rows = run.rows;
  add(list, "merger_max", scene.check.merger_max, [&]() -> Reached {
    const Series t = rows.column("t"), apart = rows.column("separation");
    const auto fallen = std::ranges::find_if(apart, [&](double b) { return b < 0.99 * apart[0]; });
    const bool whole = fallen == apart.end();
    const std::size_t r = whole ? apart.size() - 1 : fallen - apart.begin();
    const double off = pair_of(scene).core_at(t[r]) / apart[r] - exact::VortexPair::onset;
    if (whole && off <= *scene.check.merger_max) return rows.too_short();
    return {std::abs(off)};
  });
}

void check_dipole(std::vector<Verdict>& list, const Finished& run) {
  const io::Scene& scene = run.scene;
  if (scene.check.exact != io::ExactAnswer::dipole) return;
  const HistoryRows& rows = run.rows;
  add(list, "speed_max", scene.check.speed_max, [&]() -> Reached {
    const Series t = rows.column("t"), x = rows.column("plus_x"), y = rows.column("plus_y");
    if (t.size() < 2) return rows.too_short();
    const double way = std::hypot(x.back() - x[0], y.back() - y[0]);
    const exact::VortexPair pair = pair_of(scene);
    return {std::abs(deviation(way, std::abs(pair.travelled(t.back()) - pair.travelled(t[0]))))};
  });
}

namespace {

/// Columns of the report at the times of a reference that lie within it: the largest distance from
/// the reference's, as a share of the largest that its first column has been by the end.
Reached moments_off(const HistoryRows& rows, const io::Table& reference,
                    std::initializer_list<const char*> columns) {
  const Series t = reference.column("t"), ours = rows.column("t");
  if (ours.empty()) return rows.too_short();
  Series off, size;
  for (std::size_t row = 0; row < t.size() && t[row] <= ours.back() + 1e-9; ++row) {
    size.push_back(reference.column(*columns.begin())[row]);
    double squares = 0;
    bool within = true;
    for (const char* name : columns) {
      const auto value = interpolated(ours, rows.column(name), t[row]);
      within = within && value;
      if (value) squares += std::pow(*value - reference.column(name)[row], 2);
    }
    if (within) off.push_back(std::sqrt(squares));
  }
  if (off.empty()) return rows.too_short();
  return {share(largest_of(off), largest_of(size))};
}

}  // namespace

/// Quadrupole and separation at the times of a reference.
void check_moments(std::vector<Verdict>& list, const Finished& run) {
  const io::Scene& scene = run.scene;
  const HistoryRows& rows = run.rows;
  const io::CheckSettings& c = scene.check;
  if (!c.moments_reference) return;
  if (io::lacks_reference(scene, *c.moments_reference)) {
    add(list, "quadrupole_max", c.quadrupole_max, without_reference);
    add(list, "separation_max", c.separation_max, without_reference);
    return;
  }
  const io::Table reference(io::reference_path(scene, *c.moments_reference));
  add(list, "quadrupole_max", c.quadrupole_max, [&] {
    return moments_off(rows, reference, {"quadrupole_xx", "quadrupole_xy"});
  });
  add(list, "separation_max", c.separation_max,
      [&] { return moments_off(rows, reference, {"separation"}); });
}

/// What the energy differs from that at the start less what viscosity has taken (trapezoid rule
/// over the times of the frames).
void check_energy(std::vector<Verdict>& list, const Finished& run) {
  const io::Scene& scene = run.scene;
  add(list, "energy_max", scene.check.energy_max, [&]() -> Reached {
    const io::Table table(run.folder / "energy.csv");
    const Series t = table.column("t"), e = table.column("energy"), z = table.column("enstrophy");
    if (t.size() < 2) return {.value = {}, .why = "energy.csv has not two rows"};
    double taken = 0;
    Series off;
    for (std::size_t r = 1; r < t.size(); ++r) {
      taken += scene.flow.nu * (t[r] - t[r - 1]) * (z[r] + z[r - 1]) / 2;
      off.push_back(share(e[r] - e[0] + taken, e[0]));
    }
    return {largest_of(off)};
  });
}

}  // namespace vortree::checks
