#include "vortex/choice/scales.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "body/extent.hpp"
#include "flow/initial/widths.hpp"
#include "vortex/adapt/tuning.hpp"
#include "vortex/tuning.hpp"

namespace vortree::vortex {

double sharpest_tip(const VortexCase& scene) {
  double least = INFINITY;
  for (const body::BodySettings& one : flow::every_body(scene))
    least = std::min(least, body::tip_of(one).radius);
  return least;
}

double panels_of(const VortexCase& scene) {
  double sum = 0;
  for (const body::BodySettings& one : flow::every_body(scene)) sum += one.panels;
  return sum;
}

double boundary_layer(const VortexCase& scene) {
  const double speed = flow::fastest_of(scene);
  if (!scene.body || speed == 0) return 0;
  return std::sqrt(scene.flow.nu * body::length_of(*scene.body) / speed);
}

bool spreads_cores(const VortexCase& scene) {
  return scene.flow.nu > 0 && scene.diffusion.kind == Diffusion::core_spreading;
}

bool makes_children(const VortexCase& scene) {
  if (!spreads_cores(scene)) return false;
  if (scene.splitting.scheme == SplitScheme::ring) return true;
  const double least = lattice_step / sharpest_followed * scene.cores.sigma_max;
  return sharpest_tip(scene) < least;
}

double strained_for(const VortexCase& scene) {
  if (!spreads_cores(scene) || makes_children(scene) || !scene.initial) return 0;
  const double alone = strain_turn / flow::mean_vorticity(*scene.initial);
  const double step = lattice_step * scene.cores.sigma_max;
  return step * step / (8 * scene.flow.nu) <= most_layings * alone ? alone : 0;
}

double widest_in_free_space(const VortexCase& scene, double e) {
  const double width = flow::least_width(*scene.initial);
  VortexCase strained = scene;
  strained.cores.sigma_max = 0.55 * width * std::pow(e, 0.25);
  return strained_for(strained) > 0 ? strained.cores.sigma_max : 1.2 * width * std::sqrt(e);
}

double crowding(const VortexCase& scene) {
  if (!makes_children(scene)) return 1;
  const double widest = scene.cores.sigma_max, layer = boundary_layer(scene);
  double usual = 0;
  if (layer > 0)
    usual = flow::fastest_of(scene) * widest * widest / (16 * layer * layer);
  else if (scene.initial)
    usual = 0.014 * flow::mean_vorticity(*scene.initial) * widest * widest /
            flow::least_width(*scene.initial);
  const double tolerance = scene.merging.tolerance;
  return tolerance > 0 ? std::sqrt(std::clamp(usual / tolerance, 1.0, 1e6)) : 1;
}

double turn_at_wall(const VortexCase& scene) {
  const double layer = boundary_layer(scene);
  return layer > 0 ? 2 * flow::fastest_of(scene) / layer * scene.time.dt : 0;
}

double turn_of_vortex(const VortexCase& scene) {
  return scene.initial ? flow::mean_vorticity(*scene.initial) / 2 * scene.time.dt : 0;
}

namespace {

double turn_at_tip(const VortexCase& scene, const body::BodySettings& body) {
  if (body::round(body)) return 0;
  const body::Tip tip = body::tip_of(body);
  const double half = std::hypot(tip.place.x, tip.place.y);
  const auto sideways = [&](const Pair& a) {
    return std::abs(a[0] * tip.place.y - a[1] * tip.place.x) / half;
  };
  double speed = sideways(scene.flow.stream);
  if (scene.plunge) {
    const Pair& way = scene.plunge->direction;
    speed += 2 * std::numbers::pi * scene.plunge->frequency * scene.plunge->amplitude *
             sideways(way) / std::hypot(way[0], way[1]);
  }
  // A body that turns meets the stream from all sides.
  if (scene.motion && scene.motion->course.moves()) speed = flow::fastest_of(scene);
  const double rounded = std::max(tip.radius, scene.cores.sigma_0);
  return speed * std::sqrt(half / rounded) / rounded * scene.time.dt;
}

}  // namespace

double turn_at_tip(const VortexCase& scene) {
  double most = 0;
  for (const body::BodySettings& one : flow::every_body(scene))
    most = std::max(most, turn_at_tip(scene, one));
  return most;
}

double width_of_endless_splits(const VortexCase& scene) {
  const double alpha2 = scene.splitting.alpha * scene.splitting.alpha;
  return std::sqrt(alpha2 / (1 - alpha2) * 4 * scene.flow.nu * scene.time.dt);
}

bool splits_endlessly(const VortexCase& scene) {
  const double child = width_of_endless_splits(scene), widest = scene.cores.sigma_max;
  return makes_children(scene) && child * child > scene.merging.cap * widest * widest;
}

double generations(const VortexCase& scene, double time) {
  const double alpha2 = scene.splitting.alpha * scene.splitting.alpha;
  const double most2 = scene.cores.sigma_max * scene.cores.sigma_max;
  return 4 * scene.flow.nu * time / ((1 - alpha2) * most2);
}

}  // namespace vortree::vortex
