#include "app/methods/vortex.hpp"

#include <cmath>
#include <numbers>

#include "body/outline.hpp"
#include "checks/warnings/cost.hpp"
#include "io/scene/scales.hpp"
#include "vortex/blobs/lattice.hpp"
#include "vortex/solver.hpp"

namespace vortree::app {
namespace {

/// Blobs of less circulation beside a body are let go [U D]. In a run they add up to less than the
/// sums of velocities err by, and would outnumber the others (vortex/blobs/outflow.hpp).
constexpr double faintest = 1e-12;

Vec2 vec(const io::Vec2& a) {
  return {a[0], a[1]};
}

fmm::Options sums_of(const vortex::VelocitySettings& v) {
  return {
      .tolerance = v.tolerance,
      .order = v.order,
      .capacity = static_cast<std::uint32_t>(v.capacity),
      .finest_level = v.finest_level,
      .builder = v.builder,
      .cores = v.cores == vortex::PairCores::source ? fmm::Cores::source : fmm::Cores::mean,
      .method = v.method,
  };
}

std::unique_ptr<body::Shape> shape_of(const body::BodySettings& body) {
  const double incidence = body.incidence * std::numbers::pi / 180;
  if (body.shape == body::ShapeKind::ellipse)
    return body::ellipse({}, *body.radius, *body.across, incidence);
  if (body.shape == body::ShapeKind::naca0012)
    return body::naca0012({}, *body.chord, io::edge_of(body), incidence);
  return body::circle({}, *body.radius);
}

body::Plunge plunge_of(const body::PlungeSettings& plunge) {
  return {plunge.amplitude * io::unit(plunge.direction), plunge.frequency};
}

std::optional<vortex::Box> box_of(const vortex::MergingSettings& merging) {
  if (!merging.box) return std::nullopt;
  const auto [x0, y0, x1, y1] = *merging.box;
  return vortex::Box{{x0, y0}, {x1, y1}};
}

vortex::Origin origin_of(const io::Scene& scene) {
  if (scene.body) return {vec(scene.body->centre)};
  return {scene.initial ? vec(scene.initial->centre) : Vec2{}, vec(scene.flow.stream)};
}

/// One vortex on the left, and one of circulation `right` on the right.
vortex::Blobs two_vortices(vortex::Lattice lattice, const vortex::InitialSettings& i,
                           double right) {
  const Vec2 half{0.5 * *i.separation, 0};
  const Vec2 centre = lattice.centre;
  lattice.centre = centre - half;
  vortex::Blobs both = vortex::gaussian_ellipse(lattice, i.circulation, i.core, i.core);
  lattice.centre = centre + half;
  const vortex::Blobs other = vortex::gaussian_ellipse(lattice, right, i.core, i.core);
  for (std::size_t k = 0; k < other.size(); ++k)
    both.append(other.centre(k), other.gamma[k], other.sigma[k]);
  return both;
}

/// The vorticity at t = 0, as seen from the flow's origin.
vortex::Blobs initial_blobs(const io::Scene& scene) {
  if (!scene.initial) return {};
  const vortex::InitialSettings& i = *scene.initial;
  const vortex::Lattice lattice{vec(i.centre) - origin_of(scene).start, scene.cores.sigma_0,
                                i.spacing * scene.cores.sigma_0, i.faintest};
  switch (i.kind) {
    case vortex::InitialKind::gaussian_ellipse:
      return vortex::gaussian_ellipse(lattice, i.circulation, i.core, *i.core_across);
    case vortex::InitialKind::kirchhoff_ellipse:
      return vortex::uniform_ellipse(lattice, i.circulation, i.core, *i.core_across);
    case vortex::InitialKind::corotating_pair:
      return two_vortices(lattice, i, i.circulation);
    case vortex::InitialKind::dipole:
      return two_vortices(lattice, i, -i.circulation);
    case vortex::InitialKind::tripole:
      return vortex::perturbed_vortex(lattice, i.circulation, i.core, *i.perturbation);
    case vortex::InitialKind::lamb_oseen:
      break;
  }
  return vortex::gaussian_ellipse(lattice, i.circulation, i.core, i.core);
}

}  // namespace

vortex::Setup vortex_setup(const io::Scene& scene, const flow::Scales& scales) {
  vortex::Setup made;
  if (scene.body)
    made.wall = std::make_unique<vortex::Wall>(shape_of(*scene.body), scene.body->panels);
  made.blobs = initial_blobs(scene);
  made.scales = scales;
  made.origin = origin_of(scene);
  made.box = box_of(scene.merging);
  made.problem = {
      .flow = {vec(scene.flow.stream) - made.origin.drift,
               scene.flow.nu,
               scene.plunge ? plunge_of(*scene.plunge) : body::Plunge{},
               {scene.motion ? scene.motion->spin : 0}},
      .dt = scene.time.dt,
      .scheme = scene.time.scheme,
      .carrying_cores = scene.velocity.cores == vortex::PairCores::both ? std::numbers::sqrt2 : 1,
      .sigma_0 = scene.cores.sigma_0,
      .diffusion = scene.diffusion.kind,
      .area = scene.initial ? std::pow(scene.initial->spacing * scene.cores.sigma_0, 2) : 0,
      .splitting = {.sigma_max = scene.cores.sigma_max,
                    .alpha = scene.splitting.alpha,
                    .children = scene.splitting.children,
                    .seed = static_cast<std::uint64_t>(scene.seed),
                    .coarsening = {scene.cores.coarsen_from.value_or(INFINITY)}},
      .merging = {.tolerance = scene.merging.tolerance,
                  .reach = scene.merging.reach,
                  .sigma_max = std::sqrt(scene.merging.cap) * scene.cores.sigma_max},
      .faintest = made.wall ? faintest * scales.speed * scales.length : 0,
      .wall = made.wall.get(),
      .sums = sums_of(scene.velocity),
  };
  made.crowding = io::crowding(scene);
  made.splits_endlessly = io::splits_endlessly(scene);
  return made;
}

std::unique_ptr<flow::Solver> vortex_solver(const io::Scene& scene, const flow::Scales& scales,
                                            double memory) {
  vortex::Setup setup = vortex_setup(scene, scales);
  setup.held_blobs = checks::blobs_in(memory);
  return std::make_unique<vortex::Solver>(std::move(setup));
}

}  // namespace vortree::app
