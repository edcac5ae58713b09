#include "io/scene/choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/scene/scales.hpp"
#include "io/scene/time.hpp"

namespace vortree::io {
namespace {

bool written(const Document& document, std::string_view table, std::string_view key) {
  const toml::node* node = document.root().get(table);
  return node && node->is_table() && node->as_table()->contains(key);
}

void choose_viscosity(const Document& document, Scene& scene) {
  const bool given = written(document, "flow", "nu");
  if (!scene.flow.reynolds) {
    if (!given) document.refuse("flow", "[flow] needs the key nu");
    return;
  }
  const double speed = speed_of(scene);
  if (!scene.body || speed == 0)
    document.refuse("flow.reynolds",
                    fmt::format("flow.reynolds is {}; that needs [body] and a flow.stream, "
                                "[plunge] or motion.spin",
                                *scene.flow.reynolds));
  const double nu = speed * length_of(*scene.body) / *scene.flow.reynolds;
  if (given && std::abs(scene.flow.nu / nu - 1) > 1e-6)
    document.refuse("flow.reynolds",
                    fmt::format("flow.reynolds is {}, which makes flow.nu {}, but that is {}; "
                                "write one of them",
                                *scene.flow.reynolds, nu, scene.flow.nu));
  if (!given) scene.flow.nu = nu;
}

/// What an accuracy calls for.
struct Choice {
  double sigma_0, sigma_max, dt, merging, reach, cap, velocity;
  int panels;
};

Choice past_body(const Scene& scene, double e) {
  const double speed = fastest_of(scene);
  const double length = length_of(*scene.body), nu = scene.flow.nu;
  const double reynolds = speed * length / nu;
  Choice c{};
  // A scene that sets its own step has the cores that go with it.
  const double period = scene.plunge ? 1 / scene.plunge->frequency : INFINITY;
  c.dt = scene.time.dt > 0
             ? scene.time.dt
             : fitted_step(
                   scene, std::min({2 * e * length / speed,
                                    0.02 * std::sqrt(550 / reynolds) * length / speed, period / 100,
                                    0.1 * std::min(e, 0.05) * length * length / nu}));
  c.sigma_max = std::min(4 * std::sqrt(e * nu * length / speed),
                         std::sqrt(8 * nu * c.dt) * std::pow(std::max(e / 0.01, 1.0), 0.25));
  const double beside_body = reynolds < 20 ? 4 * length * std::sqrt(e / 20) : length / 4;
  c.sigma_max = std::min({c.sigma_max, beside_body, length / 4});
  c.sigma_max = std::max(c.sigma_max, std::sqrt(4 * nu * c.dt));
  c.sigma_0 = std::min(std::sqrt(2 * nu * c.dt), c.sigma_max);
  c.merging = 0.4 * std::sqrt(e) * speed;
  c.reach = 3;
  c.cap = 1.2;
  c.velocity = std::clamp(e / 1000, 1e-12, 1e-3);
  const double around = scene.body->shape == body::ShapeKind::naca0012
                            ? perimeter_of(*scene.body)
                            : std::max(perimeter_of(*scene.body), std::numbers::pi * length);
  const double tips = perimeter_of(*scene.body) / (panel_at_tip * tip_radius(*scene.body));
  c.panels =
      static_cast<int>(std::clamp(std::max(around / (2.4 * c.sigma_0), tips), 128.0, 4000.0));
  return c;
}

Choice free_vortex(const Scene& scene, double e) {
  const vortex::InitialSettings& i = *scene.initial;
  const double width = least_width(i);
  const double omega = mean_vorticity(i);
  Choice c{};
  c.sigma_max = 1.2 * width * std::sqrt(e);
  c.sigma_0 = c.sigma_max / 1.3;
  c.dt = 0.4 / omega;
  if (scene.flow.nu > 0) c.dt = std::min(c.dt, c.sigma_max * c.sigma_max / (4 * scene.flow.nu));
  c.dt = fitted_step(scene, c.dt);
  c.merging = 0.02 * e * width * omega;
  c.reach = vortex::MergingSettings{}.reach;
  c.cap = vortex::MergingSettings{}.cap;
  c.velocity = std::clamp(e / 1000, 1e-12, 1e-4);
  return c;
}

}  // namespace

void choose_missing(const Document& document, Scene& scene) {
  choose_viscosity(document, scene);
  const bool body = scene.body && speed_of(scene) > 0;
  if (scene.accuracy && ((body && scene.flow.nu > 0) || scene.initial)) {
    const double e = *scene.accuracy;
    const Choice c = body ? past_body(scene, e) : free_vortex(scene, e);
    const auto fill = [&](std::string_view table, std::string_view key, auto& target,
                          const auto& value) {
      if (!written(document, table, key)) target = value;
    };
    fill("cores", "sigma_0", scene.cores.sigma_0, c.sigma_0);
    fill("cores", "sigma_max", scene.cores.sigma_max, c.sigma_max);
    scene.origin.step_chosen = !written(document, "time", "dt");
    fill("time", "dt", scene.time.dt, c.dt);
    fill("merging", "tolerance", scene.merging.tolerance, c.merging);
    fill("merging", "reach", scene.merging.reach, c.reach);
    fill("merging", "cap", scene.merging.cap, c.cap);
    fill("velocity", "tolerance", scene.velocity.tolerance, c.velocity);
    if (body) {
      fill("body", "panels", scene.body->panels, c.panels);
      fill("velocity", "cores", scene.velocity.cores, vortex::PairCores::both);
    }
  }
  const auto require = [&](std::string_view table, std::string_view key, double value) {
    if (value == 0)
      document.refuse(table, fmt::format("[{0}] needs the key {1}, or the scene `accuracy`, "
                                         "which chooses it for a body in a stream and for an "
                                         "initial vortex",
                                         table, key));
  };
  if (by_vortices(scene)) {
    require("cores", "sigma_0", scene.cores.sigma_0);
    require("cores", "sigma_max", scene.cores.sigma_max);
  }
  require("time", "dt", scene.time.dt);
}

}  // namespace vortree::io
