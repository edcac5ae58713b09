#include "sph/choice/refusals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "body/extent.hpp"
#include "flow/solver.hpp"
#include "sph/choice/cost.hpp"

namespace vortree::sph {

void refuse_senseless(const SphCase& scene) {
  const SphSettings& own = scene.sph;
  if (!scene.body) throw Refused("method", "method is \"sph\", which needs a [body]");
  if (scene.initial)
    throw Refused("initial", "[initial] vorticity is known to vortices only; method is \"sph\"");
  if (!(scene.flow.nu > 0)) throw Refused("flow.nu", "flow.nu is 0; SPH needs a viscosity > 0");
  if (own.degree == 3) throw Refused("sph.degree", "sph.degree is 3; 2 or 4 was expected");
  const double length = body::length_of(*scene.body);
  if (own.spacing > length / 5)
    throw Refused("sph.spacing",
                  fmt::format("sph.spacing is {}; a fifth of the body's length {} at most was "
                              "expected",
                              own.spacing, length));
  const auto [x0, y0, x1, y1] = *own.box;
  const double coarsest = own.spacing * std::exp2(own.levels - 1);
  const auto [half_x, half_y] = body::half_extent(*scene.body);
  const auto [x, y] = scene.body->centre;
  const double room = (own.rings + 2) * own.spacing + 2 * coarsest;
  if (!(x0 < x - half_x - room && x1 > x + half_x + room && y0 < y - half_y - room &&
        y1 > y + half_y + room))
    throw Refused("sph.box", fmt::format("sph.box is [{}, {}, {}, {}]; the body, its rings and two "
                                         "of the coarsest spacings, {}, must lie within",
                                         x0, y0, x1, y1, coarsest));
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
