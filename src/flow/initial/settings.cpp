#include "flow/initial/settings.hpp"

namespace vortree::flow {

std::vector<Key> keys(InitialSettings& initial) {
  return {
      key("kind", initial.kind,
          "the vorticity at t = 0: a Gaussian vortex, an elliptic one, a uniform ellipse, two "
          "alike, "
          "two of opposite signs that travel along +y, one times a quadrupole"),
      key("circulation", initial.circulation, required(anything), "L^2/T",
          "of the vortex, or of each of two, the left one if they are opposite"),
      key("core", initial.core, required(positive), "L",
          "width of the vortex, or of each of two; of an ellipse half of it along x; Gaussians are "
          "wider than sigma_0"),
      key("spacing", initial.spacing, positive, "sigma_0",
          "distance of the blobs that the vorticity is cut into"),
      key("centre", initial.centre, anything, "L", "place [x, y] of its centre"),
      key("core_across", initial.core_across, positive, "L",
          "the same along y: gaussian_ellipse and kirchhoff_ellipse need it"),
      key("separation", initial.separation, positive, "L",
          "distance of two vortices along x: corotating_pair and dipole need it"),
      key("perturbation", initial.perturbation, anything, "",
          "a tripole, which needs it, is the vortex times 1 + perturbation (x^2 - y^2)/core^2"),
      key("faintest", initial.faintest,
          {.low = 0, .high = 0.1, .above_low = true, .words = "it must lie between 0 and 0.1"}, "",
          "blobs below this share of the strongest are left out")};
}

}  // namespace vortree::flow
