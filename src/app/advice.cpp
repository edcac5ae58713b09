#include "app/advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/timetable.hpp"

namespace vortree::app {
namespace {

using List = std::vector<std::string>;

void doubt_body(List& list, const io::Scene& scene, double speed) {
  const double size = io::length_of(*scene.body), nu = scene.flow.nu, dt = scene.time.dt;
  const double layer = std::sqrt(nu * size / speed), widest = scene.cores.sigma_max;
  const double error = widest * widest / (16 * layer * layer);
  if (error > 0.05)
    list.push_back(fmt::format(
        "cores.sigma_max = {:.3g} is {:.2g} of the boundary layer sqrt(nu D/U) = {:.3g}: the drag "
        "will be off by {}; {:.2g} keeps it to 1 %",
        widest, widest / layer, layer,
        error < 0.5 ? fmt::format("some {:.0f} %", 100 * error) : "more than half", 0.4 * layer));
  const double child2 =
      scene.splitting.alpha * scene.splitting.alpha * (widest * widest + 4 * nu * dt);
  if (child2 > scene.merging.cap * widest * widest)
    list.push_back(fmt::format(
        "cores.sigma_max = {:.3g}: one step of time.dt = {:.3g} widens a core so much that its "
        "children, {:.3g}, are too wide to merge: blobs will multiply until the run ends; {:.2g} "
        "is right",
        widest, dt, std::sqrt(child2), std::sqrt(4 * nu * dt)));
  const double turn = 2 * speed / layer * dt;
  if (turn > 2)
    list.push_back(fmt::format(
        "time.dt = {:.3g}: the vorticity at the wall turns by {:.2g} rad a step, more than the "
        "time integration can follow; the drag will be wrong, or the run will end early; {:.2g} is "
        "right",
        dt, turn, 0.02 * std::sqrt(550 * nu / (speed * size)) * size / speed));
  const double around = io::perimeter_of(*scene.body);
  const double panel = around / scene.body->panels, thin = scene.cores.sigma_0;
  if (panel > 6 * thin)
    list.push_back(fmt::format(
        "body.panels = {}: panels of {:.2g} are {:.2g} released cores long, so that "
        "fresh vorticity "
        "has gaps along the wall: the drag will be noisy, by percents and more; {} are enough",
        scene.body->panels, panel, panel / thin,
        static_cast<int>(std::ceil(around / (2.4 * thin)))));
  const double edge = io::edge_of(*scene.body) * size;
  if (scene.body->shape == io::Shape::naca0012 && panel > 1.5 * edge)
    list.push_back(fmt::format(
        "body.panels = {}: panels of {:.2g} do not resolve a trailing edge of radius {:.2g}: the "
        "sheet around it will be off by percents; {} are enough",
        scene.body->panels, panel, edge, static_cast<int>(std::ceil(around / (0.7 * edge)))));
  const double fresh = std::sqrt(nu * dt);
  if (thin > 3 * fresh || thin < fresh / 3)
    list.push_back(
        fmt::format("cores.sigma_0 = {:.2g} is {:.2g} of sqrt(nu dt) = {:.2g}, the age of what a "
                    "step releases: "
                    "wall vorticity and friction will be off by tens of percent",
                    thin, thin / fresh, fresh));
}

void doubt_vortex(List& list, const io::Scene& scene) {
  const io::SceneInitial& i = *scene.initial;
  const double across = i.core_across.value_or(i.core), width = std::min(i.core, across);
  const double turn =
      std::abs(i.circulation) / (2 * std::numbers::pi * i.core * across) * scene.time.dt;
  const double most = scene.time.scheme == io::TimeScheme::rk4 ? 1 : 0.5;
  if (turn > most)
    list.push_back(fmt::format(
        "time.dt = {:.3g}: the vortex turns by {:.2g} rad a step; blobs will fly off it; {:.2g} "
        "is right",
        scene.time.dt, turn, 0.2 * most * scene.time.dt / turn));
  const bool spreads = scene.flow.nu > 0;
  if (spreads && scene.cores.sigma_max > 0.5 * width)
    list.push_back(fmt::format(
        "cores.sigma_max = {:.3g} is {:.2g} of the vortex's width {:.3g}: its form will be off by "
        "tens of percent; {:.2g} keeps it to 5 %",
        scene.cores.sigma_max, scene.cores.sigma_max / width, width, 0.27 * width));
  if (i.spacing > 1.4)
    list.push_back(
        fmt::format("initial.spacing = {:.2g}: blobs so many cores apart leave gaps, an error of "
                    "{:.1g} of the vorticity from the start; 1 leaves 2e-4",
                    i.spacing, 4 * std::exp(-std::pow(std::numbers::pi / i.spacing, 2))));
}

}  // namespace

std::vector<std::string> doubts(const io::Scene& scene) {
  List list = doubts_of_times(scene);
  const double speed = io::fastest_of(scene);
  if (scene.body && speed > 0 && scene.flow.nu > 0) doubt_body(list, scene, speed);
  if (scene.initial && !scene.body) doubt_vortex(list, scene);
  return list;
}

}  // namespace vortree::app
