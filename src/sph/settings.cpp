#include "sph/settings.hpp"

namespace vortree::sph {

std::vector<Key> keys(SphSettings& sph) {
  return {
      key("spacing", sph.spacing, chosen(positive), "L", "of the particles at the body"),
      key("levels", sph.levels, chosen({.low = 1, .high = 12, .words = "it must lie in 1 .. 12"}),
          "", "so many spacings there are, each twice as wide as the one before"),
      key("zone", sph.zone, chosen(not_negative), "L",
          "nearer to the body than this particles are finest"),
      key("growth", sph.growth, {.low = 1, .words = "it must be >= 1"}, "",
          "the zone of a level is so many times as wide as that of the finer one, and two "
          "spacings more"),
      key("box", sph.box, chosen(anything), "L",
          "[x0, y0, x1, y1], what is computed; particles leave and enter through its sides"),
      key("outside", sph.outside,
          "what is beyond the box: unbounded fluid, or the stream as it is along its sides"),
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
