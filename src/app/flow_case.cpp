#include "app/flow_case.hpp"

#include <cmath>

#include "vortex/lattice.hpp"

namespace vortree::app {
namespace {

vortex::Vec2 vec(const io::Vec2& a) {
  return {a[0], a[1]};
}

std::unique_ptr<vortex::Velocity> velocity_of(const io::SceneVelocity& v) {
  const fmm::Cores cores = v.cores == io::PairCores::mean ? fmm::Cores::mean : fmm::Cores::source;
  if (v.method == io::VelocityMethod::direct) return vortex::velocity_by_direct_sum(cores);
  return vortex::velocity_by_plan({
      .tolerance = v.tolerance,
      .order = v.order,
      .capacity = static_cast<std::uint32_t>(v.capacity),
      .finest_level = v.finest_level,
      .builder =
          v.builder == io::TreeBuilder::reverse ? fmm::Builder::reverse : fmm::Builder::forward,
      .cores = cores,
      .method =
          v.method == io::VelocityMethod::fmm ? fmm::Method::fmm : fmm::Method::boxes,
  });
}

}  // namespace

FlowCase flow_case(const io::Scene& scene) {
  FlowCase made;
  if (scene.body) {
    made.wall = std::make_unique<vortex::Wall>(
        vortex::circle(vec(scene.body->centre), scene.body->radius), scene.body->panels);
    made.diameter = 2 * scene.body->radius;
  }
  const double speed = std::hypot(scene.flow.stream[0], scene.flow.stream[1]);
  if (speed > 0) made.speed = speed;
  made.velocity = velocity_of(scene.velocity);
  made.problem = {
      .flow = {vec(scene.flow.stream), scene.flow.nu},
      .dt = scene.time.dt,
      .scheme =
          scene.time.scheme == io::TimeScheme::rk4 ? vortex::Scheme::rk4 : vortex::Scheme::rk2,
      .sigma_0 = scene.cores.sigma_0,
      .splitting = {.sigma_max = scene.cores.sigma_max,
                    .alpha = scene.splitting.alpha,
                    .children = scene.splitting.children,
                    .seed = static_cast<std::uint64_t>(scene.seed)},
      .merging = {.tolerance = scene.merging.tolerance,
                  .reach = scene.merging.reach,
                  .sigma_max = std::sqrt(scene.merging.cap) * scene.cores.sigma_max},
      .wall = made.wall.get(),
      .velocity = made.velocity.get(),
  };
  return made;
}

vortex::Blobs initial_blobs(const io::Scene& scene) {
  if (!scene.initial) return {};
  const io::SceneInitial& i = *scene.initial;
  return vortex::gaussian_vortex(vec(i.centre), i.circulation, i.core, scene.cores.sigma_0,
                                 i.spacing * scene.cores.sigma_0);
}

}  // namespace vortree::app
