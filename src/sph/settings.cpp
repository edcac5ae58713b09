#include "sph/settings.hpp"

#include <algorithm>
#include <cmath>

namespace vortree::sph {

std::vector<Key> keys(RegionSettings& region) {
  return {key("centre", region.centre, required(anything), "L", "place [x, y] of its centre"),
          key("half_axes", region.half_axes, required(positive), "L",
              "half its two axes; alike in a disc"),
          key("angle", region.angle, anything, "degrees",
              "by how much the first axis is turned anticlockwise from x"),
          key("spacing", region.spacing, chosen(positive), "L",
              "of the particles in it, at most; `sph.spacing` if not written; around it they widen "
              "as beside a body")};
}

double coarsest_of(const SphSettings& sph) {
  return sph.spacing * std::exp2(sph.levels - 1);
}

double finest_of(const SphSettings& sph) {
  double finest = sph.spacing;
  for (const RegionSettings& region : sph.regions) finest = std::min(finest, region.spacing);
  return finest;
}

std::vector<Key> keys(SphSettings& sph) {
  return {
      key("spacing", sph.spacing, chosen(positive), "L",
          "of the finest particles, those at the body"),
      key("levels", sph.levels, chosen({.low = 1, .high = 12, .words = "it must lie in 1 .. 12"}),
          "", "so many spacings there are, each twice as wide as the one before"),
      key("zone", sph.zone, chosen(not_negative), "L",
          "nearer to the body than this particles are finest"),
      key("growth", sph.growth, {.low = 1, .words = "it must be >= 1"}, "",
          "the zone of a level is so many times as wide as that of the finer one, and two "
          "spacings more"),
      list("region", sph.regions, "ellipses with finer particles, a table [[sph.region]] each"),
      key("vorticity", sph.vorticity, positive, "L/T",
          "particles are finer where vorticity times their spacing is more than this, as fine as "
          "`spacing` at most"),
      key("box", sph.box, chosen(anything), "L",
          "[x0, y0, x1, y1], what is computed; particles leave and enter through its sides; a "
          "square if it is periodic"),
      key("outside", sph.outside,
          "what is beyond the box: unbounded fluid, the stream as it is along its sides, or the "
          "same "
          "flow again, which needs an [initial] flow that fills the plane"),
      key("operators", sph.operators,
          "how derivatives are found: by fits that converge, or by the sums that SPH is known for"),
      key("degree", sph.degree, {.low = 2, .high = 4, .words = "2 or 4 was expected"}, "",
          "of the polynomials on which derivatives are exact, away from boundaries"),
      key("reach", sph.reach, chosen({.low = 2, .high = 8, .words = "it must lie in 2 .. 8"}),
          "spacings", "radius of a particle's support"),
      key("rings", sph.rings, {.low = 1, .high = 16, .words = "it must lie in 1 .. 16"}, "",
          "layers of particles beside the body that stand still"),
      key("shift", sph.shift, not_negative, "",
          "how strongly particles are kept apart; less than 4 is too little in strained flow"),
      key("courant", sph.courant,
          {.low = 0, .high = 1, .above_low = true, .words = "it must be > 0 and <= 1"}, "",
          "spacings that the stream moves in a step, at most"),
      key("tolerance", sph.tolerance,
          {.low = 1e-12, .high = 0.01, .words = "it must lie in 1e-12 .. 0.01"}, "",
          "relative residual of the pressure"),
  };
}

}  // namespace vortree::sph
