#include "checks/at_wall.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "io/scene/reference.hpp"
#include "io/tables/table.hpp"

namespace vortree::checks {
namespace {

/// The time among those of wall.csv that is next to T, if one is within 0.02.
std::optional<double> frame_at(const Series& times, double T) {
  if (times.empty()) return std::nullopt;
  const double next =
      *std::ranges::min_element(times, {}, [&](double time) { return std::abs(time - T); });
  return std::abs(next - T) < 0.02 ? std::optional(next) : std::nullopt;
}

/// Relative L2 deviation of the wall vorticity, omega R/U, at the times that wall.csv and the
/// reference share.
Series wall_deviations(const io::Scene& scene, const std::filesystem::path& folder,
                       const flow::Scales& scales) {
  const io::Table reference(io::reference_path(scene, *scene.check.wall_vorticity_reference));
  const io::Table wall(folder / "wall.csv");
  const Series rT = reference.column("T"), rAngle = reference.column("theta_deg"),
               rValue = reference.column("omega_R_over_U");
  const Series T = wall.column("T"), angle = wall.column("angle_deg"),
               value = wall.column("vorticity");
  const double unit = scales.length / (2 * scales.speed);
  Series deviations;
  for (std::size_t k = 0; k < rT.size();) {
    const double time = rT[k];
    const auto frame = frame_at(T, time);
    Series x, y;
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

void add_without_reference(std::vector<Verdict>& list, const io::CheckSettings& c) {
  add(list, "wall_vorticity_max", c.wall_vorticity_max, without_reference);
  add(list, "wall_vorticity_rms", c.wall_vorticity_rms, without_reference);
}

}  // namespace

void check_wall_vorticity(std::vector<Verdict>& list, const Finished& run) {
  const io::CheckSettings& c = run.scene.check;
  if (!run.scales.body || !c.wall_vorticity_reference) return;
  if (io::lacks_reference(run.scene, *c.wall_vorticity_reference))
    return add_without_reference(list, c);
  const HistoryRows& rows = run.rows;
  const Series off = wall_deviations(run.scene, run.folder, run.scales);
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

namespace {

/// The value at 180 degrees of the even parabola a + b x^2 that fits best within 10 degrees of it;
/// of 1 - 4 sin^2 x that is 1e-4 too much.
std::optional<double> at_front(const Series& angles, const Series& values) {
  double n = 0, x2 = 0, x4 = 0, y = 0, x2y = 0;
  for (std::size_t i = 0; i < angles.size(); ++i)
    if (const double x = 180 - std::abs(angles[i]); x <= 10) {
      n += 1, x2 += x * x, x4 += x * x * x * x;
      y += values[i], x2y += x * x * values[i];
    }
  const double determinant = n * x4 - x2 * x2;
  if (!(determinant > 1e-9 * n * x4)) return std::nullopt;
  return (y * x4 - x2y * x2) / determinant;
}

/// How far C_p at the front is off the reference, at each time that both have.
Series front_deviations(const io::Scene& scene, const io::Table& wall) {
  const io::Table reference(io::reference_path(scene, *scene.check.front_pressure_reference));
  const Series rT = reference.column("T"), rValue = reference.column("cp_front");
  const Series T = wall.column("T"), angle = wall.column("angle_deg"), cp = wall.column("cp");
  Series deviations;
  for (std::size_t i = 0; i < T.size();) {
    const double time = T[i];
    Series angles, values;
    for (; i < T.size() && T[i] == time; ++i) {
      angles.push_back(angle[i]);
      values.push_back(cp[i]);
    }
    const auto ours = at_front(angles, values), known = interpolated(rT, rValue, time);
    if (ours && known && time >= scene.check.front_pressure_from.value_or(0))
      deviations.push_back(std::abs(*ours - *known));
  }
  return deviations;
}

}  // namespace

void check_front_pressure(std::vector<Verdict>& list, const Finished& run) {
  const io::CheckSettings& c = run.scene.check;
  if (!run.scales.body || !c.front_pressure_reference) return;
  add(list, "front_pressure_max", c.front_pressure_max, [&]() -> Reached {
    if (io::lacks_reference(run.scene, *c.front_pressure_reference)) return without_reference();
    const io::Table wall(run.folder / "wall.csv");
    if (!wall.has("cp")) return {.value = {}, .why = "this method tells no cp along the wall"};
    const Series off = front_deviations(run.scene, wall);
    if (!off.empty()) return {largest_of(off)};
    return run.rows.too_short();
  });
}

}  // namespace vortree::checks
