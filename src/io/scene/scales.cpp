#include "io/scene/scales.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vortree::io {

double tip_radius(const body::BodySettings& body) {
  if (body.shape == body::ShapeKind::naca0012) return edge_of(body) * length_of(body);
  const double a = *body.radius, b = body.across.value_or(a);
  return std::min(a * a / b, b * b / a);
}

double boundary_layer(const Scene& scene) {
  const double speed = fastest_of(scene);
  if (!scene.body || speed == 0) return 0;
  return std::sqrt(scene.flow.nu * length_of(*scene.body) / speed);
}

double across(const vortex::InitialSettings& initial) {
  return initial.core_across.value_or(initial.core);
}

double least_width(const vortex::InitialSettings& initial) {
  return std::min(initial.core, across(initial));
}

bool spreads_cores(const Scene& scene) {
  return scene.flow.nu > 0 && scene.diffusion.kind == vortex::Diffusion::core_spreading;
}

double crowding(const Scene& scene) {
  const double widest = scene.cores.sigma_max, layer = boundary_layer(scene);
  double usual = 0;
  if (layer > 0)
    usual = 0.1 * fastest_of(scene) * widest / layer;
  else if (scene.initial)
    usual = 0.014 * mean_vorticity(*scene.initial) * widest * widest / least_width(*scene.initial);
  const double tolerance = scene.merging.tolerance;
  return tolerance > 0 ? std::sqrt(std::clamp(usual / tolerance, 1.0, 1e6)) : 1;
}

double mean_vorticity(const vortex::InitialSettings& initial) {
  return std::abs(initial.circulation) / (std::numbers::pi * initial.core * across(initial));
}

double turn_at_wall(const Scene& scene) {
  const double layer = boundary_layer(scene);
  return layer > 0 ? 2 * fastest_of(scene) / layer * scene.time.dt : 0;
}

double turn_of_vortex(const Scene& scene) {
  return scene.initial ? mean_vorticity(*scene.initial) / 2 * scene.time.dt : 0;
}

double turn_at_tip(const Scene& scene) {
  if (!scene.body || scene.body->shape == body::ShapeKind::circle) return 0;
  const body::BodySettings& body = *scene.body;
  const double turned = body.incidence * std::numbers::pi / 180;
  const bool upright = body.across.value_or(0) > body.radius.value_or(INFINITY);
  const Vec2 long_way = upright ? Vec2{std::sin(turned), std::cos(turned)}
                                : Vec2{std::cos(turned), -std::sin(turned)};
  const auto sideways = [&](const Vec2& a) {
    return std::abs(a[0] * long_way[1] - a[1] * long_way[0]);
  };
  double speed = sideways(scene.flow.stream);
  if (scene.plunge) {
    const Vec2& way = scene.plunge->direction;
    speed += 2 * std::numbers::pi * scene.plunge->frequency * scene.plunge->amplitude *
             sideways(way) / std::hypot(way[0], way[1]);
  }
  const double half =
      body.chord ? *body.chord / 2 : std::max(*body.radius, body.across.value_or(0));
  const double round = std::max(tip_radius(body), scene.cores.sigma_0);
  return speed * std::sqrt(half / round) / round * scene.time.dt;
}

::vortree::Vec2 unit(const Vec2& a) {
  return (1 / std::hypot(a[0], a[1])) * ::vortree::Vec2{a[0], a[1]};
}

double width_of_endless_splits(const Scene& scene) {
  const double alpha2 = scene.splitting.alpha * scene.splitting.alpha;
  return std::sqrt(alpha2 / (1 - alpha2) * 4 * scene.flow.nu * scene.time.dt);
}

bool splits_endlessly(const Scene& scene) {
  const double child = width_of_endless_splits(scene), widest = scene.cores.sigma_max;
  return child * child > scene.merging.cap * widest * widest;
}

double generations(const Scene& scene, double time) {
  const double alpha2 = scene.splitting.alpha * scene.splitting.alpha;
  const double most2 = scene.cores.sigma_max * scene.cores.sigma_max;
  return 4 * scene.flow.nu * time / ((1 - alpha2) * most2);
}

}  // namespace vortree::io
