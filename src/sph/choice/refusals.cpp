#include "sph/choice/refusals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "body/extent.hpp"
#include "flow/solver.hpp"
#include "sph/choice/cost.hpp"

namespace vortree::sph {

namespace {

/// Fast enough to turn the stream that it meets.
bool plunges_upstream(const SphCase& scene) {
  const auto [u, v] = scene.flow.stream;
  if (!scene.plunge || (u == 0 && v == 0)) return false;
  const body::Plunge plunge = body::motion_of(scene.plunge, {}).plunge;
  const Vec2 fastest = plunge.omega() * plunge.amplitude;
  return std::abs(u * fastest.x + v * fastest.y) >= u * u + v * v;
}

void refuse_flow(const SphCase& scene) {
  if (!scene.body) throw Refused("method", "method is \"sph\", which needs a [body]");
  if (!(scene.flow.nu > 0)) throw Refused("flow.nu", "flow.nu is 0; SPH needs a viscosity > 0");
  if (plunges_upstream(scene))
    throw Refused(
        "plunge",
        "[plunge] is as fast along flow.stream as that: fluid would come in by the side of "
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
  const double length = body::length_of(*scene.body), thickness = thickness_of(*scene.body);
  const double most = std::min(length / 5, thickness / 2);
  if (own.spacing > most)
    throw Refused(
        "sph.spacing",
        fmt::format("sph.spacing is {}; {:.3g} at most was expected: a fifth of the body's "
                    "length, half its mean thickness",
                    own.spacing, most));
  if (own.zone < own.rings * own.spacing)
    throw Refused("sph.zone",
                  fmt::format("sph.zone is {}; the {} rings of particles beside the body must lie "
                              "within, {:.3g} or more was expected",
                              own.zone, own.rings, own.rings * own.spacing));
}

void refuse_box(const SphCase& scene) {
  const SphSettings& own = scene.sph;
  const auto [x0, y0, x1, y1] = *own.box;
  const double coarsest = own.spacing * std::exp2(own.levels - 1);
  const auto [half_x, half_y] = body::half_extent(*scene.body);
  const auto [x, y] = scene.body->centre;
  const double room = (own.rings + 2) * own.spacing + 2 * coarsest;
  if (!(x0 < x - half_x - room && x1 > x + half_x + room && y0 < y - half_y - room &&
        y1 > y + half_y + room))
    throw Refused("sph.box", fmt::format("sph.box is [{}, {}, {}, {}]; {:.3g} around the body was "
                                         "expected, for its rings and two of the widest spacings",
                                         x0, y0, x1, y1, room));
  if (spacing_at_box(scene) < 0.5 * coarsest)
    throw Refused(
        "sph.levels",
        fmt::format("sph.levels is {}; at the nearest side of the box particles are still "
                    "{:.3g} apart, less than half the widest spacing, {:.3g}: fewer levels, "
                    "a smaller zone or a larger box was expected",
                    own.levels, spacing_at_box(scene), coarsest));
}

}  // namespace

void refuse_senseless(const SphCase& scene) {
  refuse_flow(scene);
  refuse_operators(scene.sph);
  refuse_spacing(scene);
  refuse_box(scene);
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
