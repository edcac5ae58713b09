#include "sph/choice/refusals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/rounded.hpp"
#include "body/extent.hpp"
#include "flow/solver.hpp"
#include "sph/choice/cost.hpp"

namespace vortree::sph {

namespace {

/// Fast enough to turn the stream that it meets.
bool plunges_upstream(const SphCase& scene) {
  const auto [u, v] = scene.flow.stream;
  const body::Motion motion = body::motion_of(scene.plunge, scene.motion);
  if (!motion.travels() || (u == 0 && v == 0)) return false;
  const Vec2 fastest = motion.plunge.omega() * motion.plunge.amplitude;
  double along = std::abs(u * fastest.x + v * fastest.y);
  for (const double t : motion.course.times())
    along = std::max(along, dot({u, v}, motion.course.at(t).velocity));
  return along >= u * u + v * v;
}

bool periodic(const SphCase& scene) {
  return scene.sph.outside == Outside::periodic;
}

/// A box goes with a body, a periodic one with a flow that fills the plane.
void refuse_outside(const SphCase& scene) {
  const bool fills = scene.initial && scene.initial->kind->periodic;
  if (fills && !periodic(scene))
    throw Refused("sph.outside",
                  fmt::format("sph.outside is \"{}\"; for initial.kind = \"{}\", \"periodic\" was "
                              "expected",
                              word(scene.sph.outside), scene.initial->kind->name));
  if (periodic(scene) && !fills)
    throw Refused("sph.outside",
                  fmt::format("sph.outside is \"periodic\"; that needs [initial] with a flow that "
                              "fills the plane, as \"taylor_green\"{}",
                              scene.body ? ", and no [body]" : ""));
  if (!fills && !scene.body) throw Refused("method", "method is \"sph\", which needs a [body]");
}

/// Vortices begin where fluid is, and is computed.
void refuse_initial(const SphCase& scene) {
  if (!scene.initial || !scene.body) return;
  const auto [x, y] = scene.initial->centre;
  const auto [x0, y0, x1, y1] = *scene.sph.box;
  const bool within = x > x0 && x < x1 && y > y0 && y < y1;
  const bool covered = std::ranges::any_of(
      flow::every_body(scene),
      [&](const body::BodySettings& one) { return body::covers(one, scene.initial->centre); });
  if (covered || !within)
    throw Refused("initial.centre",
                  fmt::format("initial.centre = [{:.4g}, {:.4g}] lies {}; a place in the fluid was "
                              "expected",
                              x, y, within ? "within a body" : "outside of sph.box"));
}

/// Bodies that do not stand still against each other.
void refuse_own_motions(const SphCase& scene) {
  const flow::BodyList bodies = flow::every_body(scene);
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const std::optional<body::MotionSettings>& own = bodies[k].get().motion;
    if (own && own->course.moves())
      throw Refused(flow::key_of_body(scene, k, "motion"),
                    fmt::format("[body.motion] moves body[{}] against the others; SPH computes "
                                "around bodies that stand still against each other, or spin in "
                                "their places, method = \"vortex\" moves them, too",
                                k));
  }
}

void refuse_flow(const SphCase& scene) {
  refuse_outside(scene);
  refuse_initial(scene);
  if (!(scene.flow.nu > 0)) throw Refused("flow.nu", "flow.nu is 0; SPH needs a viscosity > 0");
  if (scene.motion && scene.motion->course.turns())
    throw Refused("motion",
                  "motion.angle turns the body; SPH moves it along only, method = "
                  "\"vortex\" turns it, too");
  refuse_own_motions(scene);
  if (plunges_upstream(scene))
    throw Refused(
        scene.plunge ? "plunge" : "motion",
        "the body moves as fast along flow.stream as that: fluid would come in by the side of "
        "sph.box through which it leaves; slower was expected");
}

/// Fits need neighbors enough to tell their terms apart, and no more than are near.
void refuse_operators(const SphSettings& own) {
  if (own.degree == 3) throw Refused("sph.degree", "sph.degree is 3; 2 or 4 was expected");
  const bool sums = own.operators == OperatorKind::pair_sums;
  if (sums && own.degree != 2)
    throw Refused("sph.degree", fmt::format("sph.degree is {}; sph.operators = \"pair_sums\" have "
                                            "none",
                                            own.degree));
  const auto [least, most] = own.degree > 2 ? std::pair{3.2, 5.0} : std::pair{2.4, 4.0};
  if (own.reach < least || own.reach > most)
    throw Refused("sph.reach", fmt::format("sph.reach is {}; with sph.degree = {}, {} .. {} was "
                                           "expected",
                                           own.reach, own.degree, least, most));
}

void refuse_spacing(const SphCase& scene) {
  const SphSettings& own = scene.sph;
  double most = INFINITY;
  for (const body::BodySettings& one : flow::every_body(scene))
    most = std::min({most, body::length_of(one) / 5, thickness_of(one) / 2});
  if (own.spacing > most)
    throw Refused("sph.spacing",
                  fmt::format("sph.spacing is {}; {} at most was expected: a fifth of the body's "
                              "length, half its mean thickness",
                              own.spacing, rounded_down(most, 3)));
  if (own.zone < own.rings * own.spacing)
    throw Refused("sph.zone",
                  fmt::format("sph.zone is {}; the {} rings of particles beside the body must lie "
                              "within, {} or more was expected",
                              own.zone, own.rings, rounded_up(own.rings * own.spacing, 3)));
}

/// Between the rings of two bodies there must be two rows of particles that go with the flow.
void refuse_gap(const SphCase& scene) {
  const SphSettings& own = scene.sph;
  const double gap = gap_of(scene), spacings = 2 * own.rings + 3;
  if (gap < spacings * own.spacing)
    throw Refused("sph.spacing",
                  fmt::format("sph.spacing is {}; the gap of {:.3g} between two bodies must hold "
                              "the {} rings of particles beside each and two rows between them: {} "
                              "at most, or fewer sph.rings, was expected",
                              own.spacing, gap, own.rings, rounded_down(gap / spacings, 3)));
}

void refuse_room(const SphCase& scene, const body::BodySettings& body) {
  const SphSettings& own = scene.sph;
  const auto [x0, y0, x1, y1] = *own.box;
  const auto [half_x, half_y] = body::half_extent(body);
  const auto [x, y] = body.centre;
  const double room = (own.rings + 2) * own.spacing + 2 * coarsest_of(own);
  if (!(x0 < x - half_x - room && x1 > x + half_x + room && y0 < y - half_y - room &&
        y1 > y + half_y + room))
    throw Refused("sph.box",
                  fmt::format("sph.box is [{}, {}, {}, {}]; more than {} around the body "
                              "was expected, for its rings and two of the widest "
                              "spacings",
                              x0, y0, x1, y1, rounded_up(room, 3)));
}

void refuse_box(const SphCase& scene) {
  const SphSettings& own = scene.sph;
  for (const body::BodySettings& one : flow::every_body(scene)) refuse_room(scene, one);
  const double coarsest = coarsest_of(own);
  if (spacing_at_box(scene) < 0.5 * coarsest)
    throw Refused(
        "sph.levels",
        fmt::format("sph.levels is {}; at the nearest side of the box particles are still "
                    "{:.3g} apart, less than half the widest spacing, {:.3g}: fewer levels, "
                    "a smaller zone or a larger box was expected",
                    own.levels, spacing_at_box(scene), coarsest));
}

/// Regions must be finer than what is there, but not than the body's own particles, and leave nodes
/// of the box no neighbors much finer than themselves.
void refuse_regions(const SphCase& scene) {
  const double coarsest = coarsest_of(scene.sph);
  for (const RegionSettings& region : scene.sph.regions) {
    if (scene.body && region.spacing < scene.sph.spacing)
      throw Refused("sph.region",
                    fmt::format("sph.region.spacing is {}; no particles are finer than those at "
                                "the body, sph.spacing = {} or more was expected",
                                region.spacing, scene.sph.spacing));
    if (region.spacing > coarsest)
      throw Refused("sph.region",
                    fmt::format("sph.region.spacing is {}; the widest that particles are anywhere, "
                                "{}, or less was expected",
                                region.spacing, rounded_down(coarsest, 3)));
  }
  if (scene.sph.regions.empty() || periodic(scene)) return;
  if (const double least = spacing_by_regions_at_box(scene); least < 0.5 * coarsest)
    throw Refused("sph.region",
                  fmt::format("sph.region asks for particles {:.3g} apart at a side of sph.box, "
                              "less than half the widest spacing, {:.3g}: a region farther inside "
                              "was expected",
                              least, coarsest));
}

/// Opposite sides are one: of the particles and of the flow.
void refuse_periodic_box(const SphCase& scene, double wavelength) {
  const auto [x0, y0, x1, y1] = *scene.sph.box;
  const double side = x1 - x0, waves = side / wavelength, slack = 1e-9 * std::abs(side);
  if (!(std::abs(y1 - y0 - side) <= slack && waves > 0.5 &&
        std::abs(waves - std::round(waves)) < 1e-9))
    throw Refused("sph.box", fmt::format("sph.box is [{}, {}, {}, {}]; if it is periodic, a square "
                                         "of whole wavelengths of {} was expected",
                                         x0, y0, x1, y1, wavelength));
  if (const double most = wavelength / 8; coarsest_of(scene.sph) > most * (1 + 1e-9))
    throw Refused("sph.spacing",
                  fmt::format("sph.spacing is {} and sph.levels is {}, so that particles are up to "
                              "{:.6g} apart; an eighth of initial.wavelength, {}, or less was "
                              "expected",
                              scene.sph.spacing, scene.sph.levels, coarsest_of(scene.sph),
                              rounded_down(most, 3)));
}

void refuse_periodic(const SphCase& scene) {
  refuse_periodic_box(scene, flow::periodic_flow_of(scene)->wavelength);
  if (scene.flow.stream != Pair{0, 0})
    throw Refused("flow.stream",
                  fmt::format("flow.stream is [{}, {}]; fluid in a periodic box has none beside "
                              "[initial], [0, 0] was expected",
                              scene.flow.stream[0], scene.flow.stream[1]));
}

}  // namespace

void refuse_senseless(const SphCase& scene) {
  refuse_flow(scene);
  refuse_operators(scene.sph);
  if (periodic(scene))
    refuse_periodic(scene);
  else
    refuse_spacing(scene), refuse_gap(scene), refuse_box(scene);
  refuse_regions(scene);
}

void refuse_beyond(const SphCase& scene, double memory) {
  const double particles = expected_particles(scene);
  const double most =
      std::min(static_cast<double>(flow::most_particles), memory / bytes_of_particle);
  if (particles > most)
    throw Refused("sph.spacing",
                  fmt::format("sph.spacing = {:.3g} and {} levels make {:.3g} particles; at most "
                              "{:.3g} fit here",
                              scene.sph.spacing, scene.sph.levels, particles, most));
}

}  // namespace vortree::sph
