#include "vortex/choice/warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/free_memory.hpp"
#include "body/extent.hpp"
#include "flow/initial/widths.hpp"
#include "vortex/choice/cost.hpp"
#include "vortex/choice/scales.hpp"
#include "vortex/choice/warnings_of_box.hpp"
#include "vortex/choice/warnings_of_means.hpp"

namespace vortree::vortex {
namespace {

using flow::Warnings;

void doubt_reynolds(Warnings& list, const VortexCase& scene) {
  constexpr double least = 20, most = 10'000;
  const double reynolds = flow::fastest_of(scene) * body::length_of(*scene.body) / scene.flow.nu;
  if (reynolds < 0.999 * least || reynolds > 2 * most)
    list.push_back(fmt::format(
        "flow: the Reynolds number is {:.3g}; results are held against others from {} to {}{}",
        reynolds, least, most,
        reynolds < least ? "; below, drag was within 2 % of Stokes' at 1"
                         : "; above, flows of this kind are turbulent and not plane"));
}

void doubt_cores(Warnings& list, const VortexCase& scene) {
  const double layer = boundary_layer(scene), widest = scene.cores.sigma_max;
  const double error = widest * widest / (16 * layer * layer);
  if (error > 0.05)
    list.push_back(fmt::format(
        "cores.sigma_max = {:.3g} is {:.2g} of the boundary layer sqrt(nu D/U) = {:.3g}: the drag "
        "will be off by {}; {:.2g} keeps it to 1 %",
        widest, widest / layer, layer,
        error < 0.5 ? fmt::format("some {:.0f} %", 100 * error) : "more than half", 0.4 * layer));
  const double thin = scene.cores.sigma_0, fresh = std::sqrt(scene.flow.nu * scene.time.dt);
  if (thin > 3 * fresh || thin < fresh / 3)
    list.push_back(fmt::format(
        "cores.sigma_0 = {:.2g} is {:.2g} of sqrt(nu dt) = {:.2g}, the age of what a step "
        "releases: wall vorticity and friction will be off by tens of percent",
        thin, thin / fresh, fresh));
  const double from = scene.cores.coarsen_from.value_or(INFINITY),
               size = body::length_of(*scene.body);
  if (from < 0.1 * size)
    list.push_back(fmt::format(
        "cores.coarsen_from = {:.3g}: cores may be {:.2g} times as wide already half a body's "
        "length away; {:.2g} is right",
        from, std::pow(0.5 * size / from, 0.75), 0.5 * size));
}

void doubt_step(Warnings& list, const VortexCase& scene) {
  const double size = body::length_of(*scene.body), speed = flow::fastest_of(scene);
  const double turn = turn_at_wall(scene), dt = scene.time.dt;
  if (turn > 2)
    list.push_back(fmt::format(
        "time.dt = {:.3g}: the vorticity at the wall turns by {:.2g} rad a step, more than the "
        "time integration can follow; the drag will be wrong, or the run will end early; {:.2g} is "
        "right",
        dt, turn, 0.02 * std::sqrt(550 * scene.flow.nu / (speed * size)) * size / speed));
  if (const double tips = turn_at_tip(scene); tips > 15)
    list.push_back(
        fmt::format("time.dt = {:.3g}: the flow turns around the body's edge, of radius {:.2g}, by "
                    "{:.2g} rad a "
                    "step: blobs will multiply there; {:.2g} is right",
                    dt, sharpest_tip(scene), tips, 8 * dt / tips));
  if (const double period = flow::period_of(scene); dt > 0.05 * period)
    list.push_back(fmt::format(
        "time.dt = {:.3g}: a period of the body's motion has {:.2g} steps; {:.2g} gives "
        "it 100",
        dt, period / dt, 0.01 * period));
}

void doubt_panels(Warnings& list, const body::BodySettings& body, const std::string& key,
                  double thin) {
  const body::PanelLimits limits = body::panel_limits_of(body);
  const double panel = limits.longest_of(body.panels), resolving = enough_panels * limits.needed();
  if (panel > 6 * thin)
    list.push_back(fmt::format(
        "{} = {}: panels of {:.2g} are {:.2g} released cores long, so that fresh "
        "vorticity has gaps along the wall: the drag will be noisy, by percents and more; {:.0f} "
        "are "
        "enough",
        key, body.panels, panel, panel / thin,
        std::ceil(std::max(limits.panels_with(2.4 * thin), resolving))));
  if (body.panels < few_panels * limits.needed())
    list.push_back(fmt::format(
        "{} = {}: so few do not resolve an outline with an edge of radius {:.2g}: the sheet around "
        "it will be off by {}; {:.0f} are enough",
        key, body.panels, body::tip_of(body).radius,
        body.panels < too_few_panels * limits.needed() ? "a tenth and more" : "percents",
        std::ceil(resolving)));
}

/// Cores between two bodies are folded by the nearer one alone.
void doubt_gaps(Warnings& list, const VortexCase& scene) {
  constexpr double cores_between = 6;
  const double widest = scene.cores.sigma_max;
  for (const body::NearestApproach& one : scene.meetings)
    if (one.gap < cores_between * widest)
      list.push_back(fmt::format(
          "body[{}] and body[{}] are {:.3g} apart{}, {:.2g} of cores.sigma_max = {:.3g}: what lies "
          "between them will be felt by one wall alone; cores.sigma_max = {:.2g}, by a finer "
          "accuracy, is right",
          one.first, one.second, one.gap,
          one.time > 0 ? fmt::format(" at t = {:.4g}", one.time) : "", one.gap / widest, widest,
          one.gap / cores_between));
}

void doubt_body(Warnings& list, const VortexCase& scene) {
  doubt_reynolds(list, scene);
  doubt_cores(list, scene);
  doubt_step(list, scene);
  const flow::BodyList bodies = flow::every_body(scene);
  for (std::size_t k = 0; k < bodies.size(); ++k)
    doubt_panels(list, bodies[k], flow::key_of_body(scene, k, "panels"), scene.cores.sigma_0);
  doubt_gaps(list, scene);
}

void doubt_initial(Warnings& list, const flow::InitialSettings& i, double core) {
  if (i.spacing > 1.4)
    list.push_back(
        fmt::format("initial.spacing = {:.2g}: blobs so many cores apart leave gaps, an error of "
                    "{:.1g} of the vorticity from the start; 1 leaves 2e-4",
                    i.spacing, 4 * std::exp(-std::pow(std::numbers::pi / i.spacing, 2))));
  if (i.faintest > 0.02)
    list.push_back(fmt::format(
        "initial.faintest = {:.2g}: so much of the vortex is left out around it; 1e-6 is right",
        i.faintest));
  for (std::string& doubt : i.kind->doubts(i, core)) list.push_back(std::move(doubt));
}

void doubt_vortex(Warnings& list, const VortexCase& scene) {
  const double width = flow::least_width(*scene.initial);
  const double turn = turn_of_vortex(scene);
  const double most = scene.time.scheme == flow::Scheme::rk4 ? 1 : 0.5;
  if (turn > most)
    list.push_back(fmt::format(
        "time.dt = {:.3g}: the vortex turns by {:.2g} rad a step; blobs will fly off it; {:.2g} "
        "is right",
        scene.time.dt, turn, 0.2 * most * scene.time.dt / turn));
  if (scene.flow.nu > 0 && scene.cores.sigma_max > 0.5 * width)
    list.push_back(fmt::format(
        "cores.sigma_max = {:.3g} is {:.2g} of the vortex's width {:.3g}: its form will be off by "
        "tens of percent; {:.2g} keeps it to 5 %",
        scene.cores.sigma_max, scene.cores.sigma_max / width, width, 0.27 * width));
}

/// Where doubles are too coarse for places: positions are computed as seen from the flow's centre,
/// but written as they are in the scene.
void doubt_places(Warnings& list, const VortexCase& scene) {
  constexpr double share = 0.01, spacing = 0x1p-52;
  const auto doubt = [&](const char* key, const Pair& centre, const Pair& way) {
    const double far = std::max(std::hypot(centre[0], centre[1]),
                                std::hypot(centre[0] + way[0], centre[1] + way[1]));
    if (far * spacing > share * scene.cores.sigma_0)
      list.push_back(fmt::format(
          "{} = [{:.4g}, {:.4g}]: doubles are {:.2g} apart so far from the origin, and "
          "cores.sigma_0 = {:.3g}: places in frames.h5 will be off, or all the same; within "
          "{:.2g} of it they are right",
          key, centre[0], centre[1], far * spacing, scene.cores.sigma_0,
          share * scene.cores.sigma_0 / spacing));
  };
  const double end = scene.time.end;
  const Pair drift{scene.flow.stream[0] * end, scene.flow.stream[1] * end};
  if (scene.body)
    doubt("body.centre", scene.body->centre, {});
  else if (scene.initial)
    doubt("initial.centre", scene.initial->centre, drift);
}

}  // namespace

void doubt_accuracy(Warnings& list, const VortexCase& scene) {
  if (!scene.accuracy || !scene.initial || scene.body) return;
  constexpr double as_printed = 1e-5;
  const double chosen = widest_in_free_space(scene, *scene.accuracy);
  if (std::abs(scene.cores.sigma_max - chosen) > as_printed * chosen)
    list.push_back(fmt::format(
        "accuracy = {:.3g} does not rule the error: cores.sigma_max = {:.3g} is written, and "
        "{:.3g} goes with it",
        *scene.accuracy, scene.cores.sigma_max, chosen));
}

flow::Warnings warnings(const VortexCase& scene) {
  Warnings list;
  doubt_places(list, scene);
  if (scene.body && flow::fastest_of(scene) > 0 && scene.flow.nu > 0) doubt_body(list, scene);
  if (scene.initial) doubt_initial(list, *scene.initial, scene.cores.sigma_0);
  if (scene.initial &&
      std::ranges::any_of(flow::every_body(scene), [&](const body::BodySettings& one) {
        return body::covers(one, scene.initial->centre);
      }))
    list.push_back(fmt::format(
        "initial.centre = [{:.4g}, {:.4g}] lies within the body, where no vorticity can be",
        scene.initial->centre[0], scene.initial->centre[1]));
  if (scene.initial && !scene.body) doubt_vortex(list, scene);
  for (const auto& more :
       {warnings_of_means(scene), warnings_of_box(scene), costly(scene, machine_memory())})
    list.insert(list.end(), more.begin(), more.end());
  return list;
}

}  // namespace vortree::vortex
