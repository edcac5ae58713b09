#include "vortex/choice/warnings_of_means.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "body/extent.hpp"
#include "flow/initial/widths.hpp"
#include "vortex/choice/scales.hpp"

namespace vortree::vortex {
namespace {

using flow::Warnings;

/// What becomes of blobs that do not merge.
std::string multiplies(const VortexCase& scene) {
  if (!makes_children(scene)) return "each lattice adds a row of nodes around the vorticity";
  return fmt::format("blobs split into {} for each {:.2g} of time", scene.splitting.children,
                     1 / generations(scene, 1));
}

/// Beside a body the sheet of the start splits in every part of the first step. Children of width w
/// fill w^2/(cap sigma_max^2) of the room that mergers have, and panels of more than 2.4 sigma_0
/// leave more to split: the product of the share and sqrt(panel/(2.4 sigma_0)) was 0.4 in usual
/// flows, up to 0.65 all starts settled, from 0.69 on some did not.
double crowding_at_start(const VortexCase& scene) {
  const double child = width_of_endless_splits(scene), widest = scene.cores.sigma_max,
               panel = body::panel_limits_of(*scene.body).longest_of(scene.body->panels);
  return child * child / (scene.merging.cap * widest * widest) *
         std::sqrt(panel / (2.4 * scene.cores.sigma_0));
}

void doubt_start(Warnings& list, const VortexCase& scene) {
  constexpr double risky = 0.66, good = 0.5;
  const double crowding = crowding_at_start(scene), widest = scene.cores.sigma_max;
  if (crowding < risky) return;
  const double alpha2 = scene.splitting.alpha * scene.splitting.alpha,
               ratio = good / crowding * alpha2 / (1 - alpha2),
               narrow = std::sqrt(ratio / (1 + ratio));
  list.push_back(fmt::format(
      "cores.sigma_max = {:.3g}: a step of time.dt = {:.3g} leaves children of {:.3g}, hardly less "
      "than the {:.3g} that mergers may leave: blobs may multiply from the start until the run "
      "ends; {:.2g}{} is right",
      widest, scene.time.dt, width_of_endless_splits(scene), std::sqrt(scene.merging.cap) * widest,
      widest * std::sqrt(crowding / good),
      narrow < 0.65 ? "" : fmt::format(", or splitting.alpha = {:.2g},", narrow)));
}

void doubt_splitting(Warnings& list, const VortexCase& scene) {
  const double nu = scene.flow.nu, dt = scene.time.dt, alpha = scene.splitting.alpha;
  const double child = width_of_endless_splits(scene), widest = scene.cores.sigma_max;
  const bool past_body = scene.body && flow::fastest_of(scene) > 0;
  const double room = past_body ? 0.8 : 1;  // 0.82 crowded at a body's start
  if (splits_endlessly(scene))
    list.push_back(fmt::format(
        "cores.sigma_max = {:.3g}: one step of time.dt = {:.3g} widens a core so much that its "
        "children, {:.3g}, are too wide to merge: blobs will multiply until the run ends; {:.2g} "
        "is right",
        widest, dt, child, std::max(std::sqrt(4 * nu * dt), child)));
  else if (alpha * alpha > room * scene.merging.cap)
    list.push_back(fmt::format(
        "merging.cap = {:.3g}: children of a split, {:.2g} of sigma_max wide, are {}too wide to "
        "merge; {}; 1 to 1.2 is right",
        scene.merging.cap, alpha, alpha * alpha > scene.merging.cap ? "" : "nearly ",
        multiplies(scene)));
  else if (past_body)
    doubt_start(list, scene);
  if (alpha < 0.5 || alpha > 0.9)
    list.push_back(fmt::format(
        "splitting.alpha = {:.3g}: {}; 0.7 to 0.75 is right", alpha,
        alpha < 0.5 ? "children so narrow leave gaps between them, an error of a vortex's form"
                    : "a blob that splits stays nearly as wide, and splits again at once"));
}

/// speed: that of the flow where it matters to a merger; right: the tolerance that goes with an
/// accuracy of 0.01.
void doubt_merging(Warnings& list, const VortexCase& scene, double speed, double right) {
  const double tolerance = scene.merging.tolerance;
  if (tolerance == 0)
    list.push_back(fmt::format("merging.tolerance = 0: nothing merges; {}; {:.2g} keeps them few",
                               multiplies(scene), right));
  else if (tolerance > speed)
    list.push_back(fmt::format(
        "merging.tolerance = {:.3g}: a merger may change velocities by more than the flow's own "
        "{:.2g}; {:.2g} is right",
        tolerance, speed, right));
  else if (const double more = crowding(scene); more > 3)
    list.push_back(fmt::format(
        "merging.tolerance = {:.3g}: hardly anything merges; some {:.2g} times as many blobs as "
        "with {:.2g}, which goes with cores.sigma_max = {:.3g}",
        tolerance, more, tolerance * more * more, scene.cores.sigma_max));
  if (scene.merging.reach < 0.5)
    list.push_back(fmt::format(
        "merging.reach = {:.2g}: hardly two blobs lie so few cores apart; they will multiply; 2 "
        "to 3 is right",
        scene.merging.reach));
  if (scene.merging.reach > 6)
    list.push_back(fmt::format(
        "merging.reach = {:.3g}: blobs so many cores apart are no neighbors; 2 to 3 is right",
        scene.merging.reach));
}

/// What rings alone have, written where there are none.
void doubt_idle(Warnings& list, const SplittingSettings& splitting) {
  constexpr SplittingSettings usual;
  const auto idle = [&](std::string_view key, const auto& value, const auto& of_rings) {
    if (value != of_rings)
      list.push_back(fmt::format(
          "splitting.{} = {}: wide blobs are laid onto lattices and have no children: it changes "
          "nothing; it does with splitting.scheme = \"ring\"",
          key, value));
  };
  idle("alpha", splitting.alpha, usual.alpha);
  idle("children", splitting.children, usual.children);
}

/// Where all that is too wide is laid onto lattices.
void doubt_lattice(Warnings& list, const VortexCase& scene) {
  const double widest = scene.cores.sigma_max, nu = scene.flow.nu, dt = scene.time.dt;
  if (4 * nu * dt <= 1.4 * widest * widest) return;  // what two levels are apart, but for nodes
  list.push_back(fmt::format(
      "cores.sigma_max = {:.3g}: one step of time.dt = {:.3g} widens cores by {:.3g}, more than a "
      "lattice makes up for: they will be laid onto coarser ones; {:.2g} is right",
      widest, dt, std::sqrt(4 * nu * dt), std::sqrt(4 * nu * dt)));
}

void doubt_spreading(Warnings& list, const VortexCase& scene) {
  if (!spreads_cores(scene)) return;
  if (makes_children(scene)) {
    doubt_splitting(list, scene);
  } else {
    doubt_lattice(list, scene);
    doubt_idle(list, scene.splitting);
  }
  if (scene.body && flow::fastest_of(scene) > 0) {
    const double speed = flow::fastest_of(scene);
    doubt_merging(list, scene, 0.5 * speed, 0.04 * speed);
  } else if (scene.initial) {
    const flow::InitialSettings& i = *scene.initial;
    const double swirl = flow::mean_vorticity(i) * flow::least_width(i) / 2;
    doubt_merging(list, scene, 0.1 * swirl, 4e-4 * swirl);
  }
}

void doubt_other_diffusion(Warnings& list, const VortexCase& scene) {
  const double step = std::sqrt(4 * scene.flow.nu * scene.time.dt), core = scene.cores.sigma_0;
  if (scene.diffusion.kind == Diffusion::random_walk && step > core)
    list.push_back(fmt::format(
        "time.dt = {:.3g}: blobs walk {:.2g} a step, farther than their cores, {:.2g}; {:.2g} is "
        "right",
        scene.time.dt, step, core, 0.25 * core * core / (4 * scene.flow.nu)));
  if (scene.diffusion.kind == Diffusion::particle_exchange && scene.initial &&
      scene.initial->spacing > 1)
    list.push_back(fmt::format(
        "initial.spacing = {:.2g}: blobs farther apart than their cores miss neighbors to exchange "
        "with; 0.8 is right",
        scene.initial->spacing));
}

void doubt_sums(Warnings& list, const VelocitySettings& velocity) {
  if (velocity.method == fmm::SumMethod::direct) return;
  const std::string few = doubt_of_terms(
      velocity.order, fmt::format("velocity.order = {}", velocity.order), "velocity.tolerance");
  if (!few.empty())
    list.push_back(few);
  else if (velocity.tolerance > 5e-3)
    list.push_back(
        fmt::format("velocity.tolerance = {:.2g}: every velocity may be off by so much of itself; "
                    "1e-4 is right",
                    velocity.tolerance));
}

}  // namespace

std::string doubt_of_terms(int order, std::string_view given, std::string_view tolerance) {
  constexpr int enough = 7;
  if (order <= 0 || order >= enough) return "";
  return fmt::format("{}: so few terms err by some {:.1g}, whatever {} is; 0 chooses them", given,
                     0.1 * std::pow(0.5, order), tolerance);
}

Warnings warnings_of_means(const VortexCase& scene) {
  Warnings list;
  doubt_spreading(list, scene);
  doubt_other_diffusion(list, scene);
  doubt_sums(list, scene.velocity);
  return list;
}

}  // namespace vortree::vortex
