#include "vortex/settings.hpp"

namespace vortree::vortex {

std::vector<Key> keys(CoreSettings& cores) {
  return {key("sigma_0", cores.sigma_0, chosen(positive), "L",
              "core of a blob that is released at the wall, or of an initial blob"),
          key("sigma_max", cores.sigma_max, chosen(positive), "L", "a wider blob splits"),
          key("coarsen_from", cores.coarsen_from, positive, "L",
              "further than this from the body cores, and the tolerance of mergers, may be "
              "(distance/coarsen_from)^(3/4) times as wide")};
}

std::vector<Key> keys(SplittingSettings& splitting) {
  constexpr Rule inside{
      .low = 0.1, .high = 1, .below_high = true, .words = "it must be >= 0.1 and < 1"};
  return {key("scheme", splitting.scheme,
              "what wide blobs become away from the body: nodes of a lattice, which keeps wakes "
              "smooth, or rings of children"),
          key("alpha", splitting.alpha, inside, "", "a child has the core alpha sigma"),
          key("children", splitting.children,
              {.low = 3, .high = 64, .words = "a ring has 3 to 64 children"}, "",
              "so many children stand on a ring")};
}

std::vector<Key> keys(MergingSettings& merging) {
  return {
      key("tolerance", merging.tolerance, not_negative, "L/T",
          "error of velocity that a merger may make; 0: blobs never merge"),
      key("reach", merging.reach, positive, "cores",
          "partners are closer than so many of the smaller core"),
      key("cap", merging.cap, positive, "", "a merged blob has sigma^2 <= cap sigma_max^2"),
      key("box", merging.box, anything, "L",
          "[x0, y0, x1, y1]: blobs that leave it are taken away, and beside a body drift on as a "
          "few vortices; `summary.json` says how much they were")};
}

std::vector<Key> keys(DiffusionSettings& diffusion) {
  return {key("kind", diffusion.kind,
              "how vorticity spreads: cores widen, or they stay and blobs walk at random or "
              "exchange circulation, in free space only")};
}

std::vector<Key> keys(VelocitySettings& velocity) {
  return {
      key("method", velocity.method,
          "how velocities are summed: by the full FMM, by series of boxes, over all pairs"),
      key("tolerance", velocity.tolerance,
          {.low = 1e-14, .high = 0.1, .words = "it must lie in 1e-14 .. 0.1"}, "",
          "relative error of a velocity sum"),
      key("order", velocity.order,
          {.low = 0, .high = 100, .words = "it must lie in 0 .. 100; 0: from the tolerance"}, "",
          "terms of a series; 0: from the tolerance"),
      key("capacity", velocity.capacity, {.low = 0, .words = "it must be >= 0; 0: chosen"}, "",
          "most blobs in a childless cell; 0: chosen"),
      key("finest_level", velocity.finest_level,
          {.low = 0, .high = 31, .words = "it must lie in 0 .. 31"}, "",
          "deepest level of the tree"),
      key("builder", velocity.builder, "the tree is built from its leaves up, or from its root"),
      key("cores", velocity.cores,
          "core of a pair: the mean (conserves impulse), the source's, or both: each blob moves "
          "with the mean over its own core (conserves the energy of free space)")};
}

std::vector<SceneTable> tables(VortexSettings& of) {
  return {table("diffusion", of.diffusion), table("cores", of.cores),
          table("splitting", of.splitting), table("merging", of.merging),
          table("velocity", of.velocity)};
}

}  // namespace vortree::vortex
