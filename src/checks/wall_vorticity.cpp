#include "checks/wall_vorticity.hpp"

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

}  // namespace vortree::checks
