#include "sph/neighbors/settings.hpp"

namespace vortree::sph {

std::vector<Key> keys(NeighborSettings& of) {
  return {
      key("method", of.method, "how SPH finds neighbors in every step: by QCG or a rival of it"),
      key("sorted", of.sorted, anything, "",
          "neighbors stand in the order of their numbers: the same bits by any method"),
      key("skin", of.skin, {.low = 0, .high = 4, .words = "it must lie in 0 .. 4"}, "spacings",
          "lists reach so much farther, and are kept until particles have moved half of it; 0: "
          "they are made anew in every step"),
  };
}

}  // namespace vortree::sph
