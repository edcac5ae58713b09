#include "vortex/choice/refusals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "body/extent.hpp"
#include "flow/initial/widths.hpp"
#include "vortex/choice/scales.hpp"

namespace vortree::vortex {
namespace {

/// Of the body's length. A blob is released as long as a panel and as thick as a core, and its
/// covariance keeps both where their squares are less than 1e16 apart.
constexpr double thinnest_core = 1e-6;

Pair seen_from(const Pair& at, const Pair& from) {
  return {at[0] - from[0], at[1] - from[1]};
}

/// What several keys must fulfil together.
void hold_together(const VortexCase& scene) {
  const CoreSettings& cores = scene.cores;
  if (cores.sigma_max < cores.sigma_0)
    throw Refused("cores.sigma_max",
                  fmt::format("cores.sigma_max is {}; it must be >= cores.sigma_0 = {}",
                              cores.sigma_max, cores.sigma_0));
  if (scene.initial) flow::refuse(*scene.initial, cores.sigma_0);
  if (scene.body && scene.diffusion.kind != Diffusion::core_spreading)
    throw Refused("diffusion.kind",
                  fmt::format("diffusion.kind is \"{}\"; beside a body vorticity diffuses by "
                              "core_spreading only",
                              word(scene.diffusion.kind)));
  if (!scene.body && !scene.initial)
    throw Refused("", "a scene needs [body] or [initial]; without both there is no vorticity");
  if (const auto& box = scene.merging.box; box && !((*box)[0] < (*box)[2] && (*box)[1] < (*box)[3]))
    throw Refused("merging.box",
                  "merging.box is [x0, y0, x1, y1]; x0 < x1 and y0 < y1 were expected");
  if (cores.coarsen_from && !scene.body)
    throw Refused("cores.coarsen_from",
                  "cores.coarsen_from is a distance from the body; there is no [body]");
}

void hold_distance(const VortexCase& scene) {
  const auto [x, y] = seen_from(scene.initial->centre, scene.body->centre);
  const double most = 1e5 * scene.cores.sigma_0;
  if (std::hypot(x, y) > most)
    throw Refused("initial.centre",
                  fmt::format("initial.centre is {} away from body.centre; blobs of "
                              "cores.sigma_0 = {} can be {} away at most",
                              std::hypot(x, y), scene.cores.sigma_0, most));
}

void hold_cores(const VortexCase& scene, const body::BodySettings& body) {
  const double half = body::length_of(body) / 2;
  for (const auto& [key, core] : {std::pair{"cores.sigma_0", scene.cores.sigma_0},
                                  std::pair{"cores.sigma_max", scene.cores.sigma_max}})
    if (core > half)
      throw Refused(key, fmt::format("{} is {}; cores wider than half the body's length, {}, "
                                     "know nothing of it",
                                     key, core, half));
  if (const double least = thinnest_core * 2 * half; scene.cores.sigma_0 < least)
    throw Refused("cores.sigma_0",
                  fmt::format("cores.sigma_0 is {}; cores thinner than {:.0e} of the body's "
                              "length, {:.3g}, are lost beside panels",
                              scene.cores.sigma_0, thinnest_core, least));
}

void hold_steps(const VortexCase& scene) {
  const double dt = scene.time.dt;
  if (const double period = flow::period_of(scene); dt > 0.25 * period)
    throw Refused(scene.plunge ? "plunge.frequency" : "motion",
                  fmt::format("a period of the body's motion, {:.3g}, has {:.2g} steps of "
                              "time.dt = {}; {:.2g} gives it 100",
                              period, period / dt, dt, 0.01 * period));
  if (const double core = scene.cores.sigma_0;
      scene.diffusion.kind == Diffusion::particle_exchange &&
      scene.flow.nu * dt > 0.5 * core * core)
    throw Refused("diffusion.kind",
                  fmt::format("diffusion.kind is \"particle_exchange\"; that is unstable for "
                              "time.dt = {}, which may be sigma_0^2/(2 nu) = {:.3g} at most",
                              dt, 0.5 * core * core / scene.flow.nu));
  constexpr double most_turn = 100, good_turn = 0.5;
  if (const double turn = std::max(turn_at_wall(scene), turn_of_vortex(scene)); turn > most_turn)
    throw Refused("time.dt",
                  fmt::format("time.dt is {}; vorticity would turn by {:.3g} rad a step; {:.2g} "
                              "lets it turn by {}",
                              dt, turn, dt * good_turn / turn, good_turn));
}

void hold_tips(const body::BodySettings& body, const std::string& key) {
  const double needed = body::panel_limits_of(body).needed();
  if (body.panels >= blind_panels * needed) return;
  throw Refused(key,
                fmt::format("{} is {}; so few step over the body's tips of radius {:.3g}; at "
                            "least {:.0f} see them, {:.0f} resolve them",
                            key, body.panels, body::tip_of(body).radius,
                            std::ceil(blind_panels * needed), std::ceil(enough_panels * needed)));
}

/// merging.box must hold what fills a rectangle.
void hold_box(const std::array<double, 4>& box, const std::array<double, 4>& filled,
              std::string_view what) {
  const auto [x0, y0, x1, y1] = box;
  const auto [left, low, right, high] = filled;
  if (x0 <= left && right <= x1 && y0 <= low && high <= y1) return;
  throw Refused("merging.box",
                fmt::format("merging.box is [{}, {}, {}, {}]; it must hold {}, which fills "
                            "[{:.4g}, {:.4g}, {:.4g}, {:.4g}]",
                            x0, y0, x1, y1, what, left, low, right, high));
}

}  // namespace

void refuse_senseless(const VortexCase& scene) {
  hold_together(scene);
  if (scene.initial && scene.body) hold_distance(scene);
  const flow::BodyList bodies = flow::every_body(scene);
  for (const body::BodySettings& one : bodies) hold_cores(scene, one);
  hold_steps(scene);
  for (std::size_t k = 0; k < bodies.size(); ++k)
    hold_tips(bodies[k], flow::key_of_body(scene, k, "panels"));
  if (!scene.merging.box) return;
  const body::Bodies placed = flow::bodies_of(scene);
  for (std::size_t k = 0; k < bodies.size(); ++k)
    hold_box(*scene.merging.box, body::place_of(placed[k], scene.time.end),
             bodies.size() == 1 ? "the body" : fmt::format("body[{}], wherever it goes", k));
  if (scene.initial) {
    const auto [x, y] = flow::half_extent(*scene.initial);
    const auto [a, b] = scene.initial->centre;
    hold_box(*scene.merging.box, {a - x, b - y, a + x, b + y}, "the initial vorticity");
  }
}

}  // namespace vortree::vortex
