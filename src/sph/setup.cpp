#include "sph/setup.hpp"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "base/random.hpp"
#include "sph/boundary/wall_nodes.hpp"
#include "sph/motion/shift.hpp"
#include "sph/motion/tuning.hpp"

namespace vortree::sph {
namespace {

/// Where a flow is seen from.
Vec2 centre_of(const SphCase& scene) {
  if (scene.body) return {scene.body->centre[0], scene.body->centre[1]};
  return {(*scene.sph.box)[0], (*scene.sph.box)[1]};
}

OuterBox box_of(const SphCase& scene) {
  const auto [x0, y0, x1, y1] = *scene.sph.box;
  const Vec2 centre = centre_of(scene);
  return {Vec2{x0, y0} - centre, Vec2{x1, y1} - centre};
}

/// The side by which the stream leaves.
bool leaves(const BoundaryNode& node, Vec2 stream) {
  const bool across = std::abs(stream.y) > std::abs(stream.x);
  const double outward = -dot(node.normal, stream);
  return outward > 0 && (node.normal.y != 0) == across;
}

void add_box(Cloud& cloud, const SphSetup& setup) {
  const Ambient& ambient = setup.ambient;
  std::int32_t number = 0;
  for (const BoundaryNode& node : box_nodes(setup.box, setup.wanted.coarsest())) {
    const bool outlet = leaves(node, ambient.steady);
    cloud.add(node, outlet ? ParticleKind::outlet : ParticleKind::outer, number++);
  }
}

void add_body(Cloud& cloud, const StandingBody& body, int rings) {
  auto number = static_cast<std::int32_t>(body.first);
  for (const BoundaryNode& node : wall_nodes(*body.shape, body.nodes))
    cloud.add(node, ParticleKind::wall, number++);
  for (int ring = 1; ring <= rings; ++ring)
    for (const BoundaryNode& node :
         ring_nodes(*body.shape, ring * body.spacing, body.spacing, ring % 2 == 0)) {
      const std::size_t i = cloud.add(node, ParticleKind::ring, ring);
      cloud.spacing[i] = std::sqrt(node.spacing * body.spacing);
    }
}

struct StartSquare {
  Vec2 middle;
  double side;
};

std::vector<StartSquare> split(const std::vector<StartSquare>& squares,
                               const WantedSpacing& wanted) {
  std::vector<StartSquare> finer;
  for (const StartSquare& one : squares) {
    if (wanted.at(one.middle) > 0.75 * one.side) {
      finer.push_back(one);
      continue;
    }
    for (const Vec2 corner : {Vec2{-1, -1}, Vec2{1, -1}, Vec2{-1, 1}, Vec2{1, 1}})
      finer.push_back({one.middle + one.side / 4 * corner, one.side / 2});
  }
  return finer;
}

void add_lattice(Cloud& cloud, const SphSetup& setup) {
  const OuterBox& box = setup.box;
  const double coarsest = setup.wanted.coarsest();
  const auto [width, height] = box.size();
  const long across = std::lround(width / coarsest), up = std::lround(height / coarsest);
  const double dx = width / across, dy = height / up;
  std::vector<StartSquare> squares;
  for (long i = 0; i < across; ++i)
    for (long j = 0; j < up; ++j)
      squares.push_back({box.low + Vec2{(i + 0.5) * dx, (j + 0.5) * dy}, std::sqrt(dx * dy)});
  for (double s = coarsest; s > 1.5 * setup.wanted.finest(); s /= 2)
    squares = split(squares, setup.wanted);
  for (const StartSquare& one : squares)
    if (!setup.bodies().within(one.middle, setup.confines.rings + 0.55))
      cloud.add(one.middle, one.side, ParticleKind::fluid);
}

/// A number from -1 to 1, its own for every k.
double chance(std::uint64_t seed, std::uint64_t k) {
  return 0x1p-52 * static_cast<double>(splitmix64(seed ^ splitmix64(k)) >> 11) - 1;
}

void scatter(Cloud& cloud, std::uint64_t seed) {
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!cloud.free(i)) continue;
    cloud.x[i] += start_disorder * cloud.spacing[i] * chance(seed, 2 * i);
    cloud.y[i] += start_disorder * cloud.spacing[i] * chance(seed, 2 * i + 1);
  }
}

/// The initial flow as seen from a place.
std::optional<flow::PeriodicFlow> periodic_of(const SphCase& scene, Vec2 from) {
  auto flow = flow::periodic_flow_of(scene);
  if (!flow) return flow;
  flow->velocity = [from, of = flow->velocity](Vec2 at, double t) { return of(at + from, t); };
  flow->pressure = [from, of = flow->pressure](Vec2 at, double t) { return of(at + from, t); };
  return flow;
}

/// What all flows have.
SphSetup setup_without_body(const SphCase& scene) {
  const SphSettings& own = scene.sph;
  const OuterBox box = box_of(scene);
  const double period = own.outside == Outside::periodic ? box.size().x : 0;
  constexpr OuterBox anywhere{{-endless, -endless}, {endless, endless}};
  const OuterBox confines = period > 0 ? anywhere : box;
  SphSetup setup{
      .scales = flow::scales_of(scene),
      .ambient = {.nu = scene.flow.nu, .steady = {scene.flow.stream[0], scene.flow.stream[1]}},
      .centre = centre_of(scene),
      .periodic = periodic_of(scene, centre_of(scene)),
      .box = box,
      .wanted = wanted_of(own, nullptr, centre_of(scene), period),
      .confines = {.box = confines},
      .operators = {own.degree, own.reach, period, nullptr, own.operators, scene.neighbors},
      .far_field = own.outside == Outside::free,
      .shift = own.shift,
      .courant = own.courant,
      .tolerance = own.tolerance,
      .dt = scene.time.dt,
      .seed = static_cast<std::uint64_t>(scene.seed),
  };
  if (own.vorticity) setup.by_vorticity = {*own.vorticity, own.spacing, confines};
  return setup;
}

}  // namespace

WantedSpacing wanted_of(const SphSettings& own, std::shared_ptr<const body::Shape> shape, Vec2 from,
                        double period) {
  WantedSpacing wanted(std::move(shape), own.spacing, own.levels, own.zone, own.growth, period);
  for (const auto& [centre, half_axes, angle, spacing] : own.regions) {
    const Vec2 at = Vec2{centre[0], centre[1]} - from;
    wanted.add_ellipse({wrapped(at.x, period), wrapped(at.y, period)}, half_axes,
                       angle * std::numbers::pi / 180, spacing);
  }
  return wanted;
}

StandingBodies bodies_of(const SphCase& scene) {
  std::vector<StandingBody> all;
  for (const body::Body& one : flow::bodies_of(scene))
    all.push_back(stand(one.shape, scene.sph.spacing, one.centre - centre_of(scene),
                        one.motion.spin.rate + one.own.spin.rate));
  return StandingBodies(std::move(all));
}

SphSetup setup_of(const SphCase& scene) {
  SphSetup setup = setup_without_body(scene);
  if (!scene.body) return setup;
  setup.ambient.motion = body::motion_of(scene.plunge, scene.motion);
  setup.motion_period = flow::period_of(scene);
  setup.confines.bodies = bodies_of(scene), setup.confines.rings = scene.sph.rings;
  setup.initial = scene.initial;
  setup.operators.body = setup.bodies().shape().get();
  setup.wanted = wanted_of(scene.sph, setup.bodies().shape(), setup.centre);
  return setup;
}

Cloud starting_cloud(const SphSetup& setup) {
  Cloud cloud;
  if (!setup.bodies().empty()) add_box(cloud, setup);
  for (const StandingBody& one : setup.bodies()) add_body(cloud, one, setup.confines.rings);
  add_lattice(cloud, setup);
  scatter(cloud, setup.seed);
  sort(cloud);
  settle(cloud, setup.operators);
  return cloud;
}

void settle(Cloud& cloud, const OperatorOptions& options) {
  Stencils stencils;
  for (int k = 0; k < spreading_steps; ++k) {
    stencils.renew(cloud, options);
    spread_evenly(cloud, stencils);
    wrap(cloud, options.period);
  }
  sort(cloud);
}

}  // namespace vortree::sph
