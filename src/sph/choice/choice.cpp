#include "sph/choice/choice.hpp"

#include <algorithm>
#include <cmath>

#include "body/extent.hpp"
#include "flow/steps.hpp"
#include "sph/choice/cost.hpp"

namespace vortree::sph {
namespace {

/// 5 times its extent around a body, and 7 on the side to which the stream goes.
std::array<double, 4> box_around(const body::BodySettings& body, const flow::Case& of) {
  const double d = extent_of(body);
  const auto [x, y] = body.centre;
  const auto [u, v] = of.flow.stream;
  std::array<double, 4> box{x - 5 * d, y - 5 * d, x + 5 * d, y + 5 * d};
  if (u == 0 && v == 0) return box;
  const bool across = std::abs(v) > std::abs(u);
  if (across)
    v > 0 ? box[3] += 2 * d : box[1] -= 2 * d;
  else
    u > 0 ? box[2] += 2 * d : box[0] -= 2 * d;
  return box;
}

/// What holds those of all bodies.
std::array<double, 4> usual_box(const flow::Case& of) {
  std::array<double, 4> all = box_around(*of.body, of);
  for (const body::BodySettings& one : flow::every_body(of)) {
    const auto [x0, y0, x1, y1] = box_around(one, of);
    all = {std::min(all[0], x0), std::min(all[1], y0), std::max(all[2], x1), std::max(all[3], y1)};
  }
  return all;
}

int usual_levels(double spacing, double length) {
  return 1 + std::clamp(static_cast<int>(std::ceil(std::log2(length / 5 / spacing) - 0.01)), 0, 11);
}

/// What the layers of all bodies want.
double fitting_spacing(const flow::Case& of, double accuracy) {
  double least = INFINITY;
  for (const body::BodySettings& one : flow::every_body(of)) {
    const double length = body::length_of(one);
    const double reynolds = flow::fastest_of(of) * length / of.flow.nu;
    const double own = std::min(5 * accuracy * std::min(1.0, std::sqrt(20 / reynolds)), 0.1);
    least = std::min(least, own * length);
  }
  return least;
}

/// Fits of degree 4 and sums want more neighbors.
bool wide(const SphSettings& own) {
  return own.degree > 2 || own.operators == OperatorKind::pair_sums;
}

/// The widest spacing is wanted farther off than the box reaches.
bool beyond_box(const SphCase& scene) {
  return spacing_at_box(scene) < 0.6 * scene.sph.spacing * std::exp2(scene.sph.levels - 1);
}

/// A step is as long as the fastest particle may go.
void choose_step(flow::Case& of, const SphSettings& own, double speed,
                 const flow::Written& written) {
  if (!written("time", "dt") && speed > 0)
    of.time.dt = flow::fitted_step(of, own.courant * finest_of(own) / speed);
}

/// That of all, and of regions that do not say their own.
void complete_spacing(SphSettings& own) {
  if (!(own.spacing > 0))
    throw Refused("sph.spacing",
                  "sph.spacing is neither written nor chosen; write it, or accuracy, as 0.01");
  for (RegionSettings& region : own.regions)
    if (region.spacing == 0) region.spacing = own.spacing;
}

/// Of a flow that is the same again after each wavelength.
void choose_periodic(flow::Case& of, const flow::PeriodicFlow& flow, SphSettings& own,
                     const flow::Written& written) {
  const auto open = [&](std::string_view key) { return !written("sph", key); };
  const double L = flow.wavelength;
  const auto [x, y] = of.initial->centre;
  if (open("spacing") && of.accuracy) own.spacing = L / std::ceil(std::sqrt(2 / *of.accuracy));
  complete_spacing(own);
  if (open("levels")) own.levels = 1;
  if (open("box")) own.box = {x, y, x + L, y + L};
  choose_step(of, own, flow.speed, written);
}

}  // namespace

void choose_missing(flow::Case& of, SphSettings& own, const flow::Written& written) {
  const auto open = [&](std::string_view key) { return !written("sph", key); };
  if (open("reach")) own.reach = wide(own) ? 3.9 : 2.8;
  if (const auto periodic = flow::periodic_flow_of(of))
    return choose_periodic(of, *periodic, own, written);
  if (!of.body) return;
  const auto [shortest, longest] = lengths_of(of);
  if (open("spacing") && of.accuracy) own.spacing = fitting_spacing(of, *of.accuracy);
  complete_spacing(own);
  if (open("levels")) own.levels = usual_levels(own.spacing, shortest);
  if (open("zone")) own.zone = std::max(longest / 2, own.rings * own.spacing);
  if (open("box")) own.box = usual_box(of);
  while (open("levels") && own.levels > 1 && beyond_box({of, own})) --own.levels;
  choose_step(of, own, flow::fastest_of(of), written);
}

}  // namespace vortree::sph
