#include "vortex/setup.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "vortex/blobs/lattice.hpp"
#include "vortex/choice/scales.hpp"
#include "vortex/tuning.hpp"

namespace vortree::vortex {
namespace {

Vec2 vec(const Pair& a) {
  return {a[0], a[1]};
}

fmm::Options sums_of(const VelocitySettings& v) {
  return {
      .tolerance = v.tolerance,
      .order = v.order,
      .capacity = static_cast<std::uint32_t>(v.capacity),
      .finest_level = v.finest_level,
      .builder = v.builder,
      .cores = v.cores == PairCores::source ? fmm::Cores::source : fmm::Cores::mean,
      .method = v.method,
  };
}

std::optional<Box> box_of(const MergingSettings& merging) {
  if (!merging.box) return std::nullopt;
  const auto [x0, y0, x1, y1] = *merging.box;
  return Box{{x0, y0}, {x1, y1}};
}

Origin origin_of(const VortexCase& scene) {
  if (scene.body) return {vec(scene.body->centre)};
  return {scene.initial ? vec(scene.initial->centre) : Vec2{}, vec(scene.flow.stream)};
}

/// The vorticity at t = 0, as seen from the flow's origin.
Blobs initial_blobs(const VortexCase& scene) {
  if (!scene.initial) return {};
  const flow::InitialSettings& i = *scene.initial;
  const double sigma_0 = scene.cores.sigma_0;
  return cut({vec(i.centre) - origin_of(scene).start, sigma_0, i.spacing * sigma_0, i.faintest}, i);
}

/// In the axes of a body that is turned as the flow begins. (Initial blobs are round.)
Blobs turned(Blobs blobs, const Turn& turn) {
  for (std::size_t k = 0; k < blobs.size(); ++k)
    blobs.put(k, turn(blobs.centre(k)), blobs.gamma[k], blobs.core(k));
  return blobs;
}

/// Those outside of a body.
Blobs outside(const body::Shape& shape, const Blobs& all) {
  Blobs kept;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (shape.distance(all.centre(k)) > 0) kept.append(all.centre(k), all.gamma[k], all.sigma[k]);
  return kept;
}

/// As seen from the first of them. One alone turns with the frame.
std::shared_ptr<const MovingWall> wall_of(const body::Bodies& bodies) {
  if (bodies.empty()) return nullptr;
  const body::Body& first = bodies.front();
  std::vector<WallBody> all;
  std::vector<body::Motion> own;
  for (const body::Body& one : bodies) {
    all.push_back({one.shape, one.panels, one.centre - first.centre});
    own.push_back(one.own);
  }
  return std::make_shared<MovingWall>(std::move(all), std::move(own), first.motion.turns());
}

/// Of several bodies: a single one moves with the frame.
std::vector<body::Motion> own_motions(const body::Bodies& bodies) {
  if (bodies.size() < 2) return {};
  std::vector<body::Motion> own;
  for (const body::Body& one : bodies) own.push_back(one.own);
  return own;
}

}  // namespace

Setup setup_of(const VortexCase& scene) {
  Setup made;
  const flow::Scales scales = flow::scales_of(scene);
  const body::Bodies bodies = flow::bodies_of(scene);
  const body::Motion motion = bodies.empty() ? body::Motion{} : bodies.front().motion;
  made.wall = wall_of(bodies);
  made.blobs = turned(initial_blobs(scene), Turn(-motion.at(0).angle));
  if (made.wall) made.blobs = outside(made.wall->at(0)->wall.shape(), made.blobs);
  made.scales = scales;
  made.origin = origin_of(scene);
  made.box = box_of(scene.merging);
  made.problem = {
      .flow = {vec(scene.flow.stream) - made.origin.drift, scene.flow.nu, motion,
               own_motions(bodies)},
      .dt = scene.time.dt,
      .scheme = scene.time.scheme,
      .advecting_cores = scene.velocity.cores == PairCores::both ? std::numbers::sqrt2 : 1,
      .strained_for = strained_for(scene),
      .sigma_0 = scene.cores.sigma_0,
      .diffusion = scene.diffusion.kind,
      .area = scene.initial ? std::pow(scene.initial->spacing * scene.cores.sigma_0, 2) : 0,
      .splitting = {.sigma_max = scene.cores.sigma_max,
                    .alpha = scene.splitting.alpha,
                    .children = scene.splitting.children,
                    .seed = static_cast<std::uint64_t>(scene.seed),
                    .coarsening = {scene.cores.coarsen_from.value_or(INFINITY)},
                    .scheme = scene.splitting.scheme,
                    .faint = faint_vorticity * scene.merging.tolerance / scene.cores.sigma_max},
      .merging = {.tolerance = scene.merging.tolerance,
                  .reach = scene.merging.reach,
                  .sigma_max = std::sqrt(scene.merging.cap) * scene.cores.sigma_max},
      .faintest = made.wall ? faintest_kept * scales.speed * scales.length : 0,
      .unfelt = merged_unfelt * scales.speed,
      .moving = made.wall.get(),
      .sums = sums_of(scene.velocity),
  };
  stand(made.problem, 0);
  made.crowding = crowding(scene);
  made.splits_endlessly = splits_endlessly(scene);
  return made;
}

}  // namespace vortree::vortex
