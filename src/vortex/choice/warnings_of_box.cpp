#include "vortex/choice/warnings_of_box.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "body/extent.hpp"
#include "flow/initial/widths.hpp"
#include "vortex/choice/scales.hpp"

namespace vortree::vortex {
namespace {

/// How far from the body, on a side of this outward normal, blobs must stay for the drag to keep to
/// 1 % (with circles at Re = 20, 100 and 550): all around while the layer grows and separates,
/// downstream as far as the wake has come, up to eight lengths, hardly upstream.
double far_enough(const VortexCase& scene, const Pair& normal) {
  const double size = body::length_of(*scene.body), layer = boundary_layer(scene),
               end = scene.time.end, speed = std::hypot(scene.flow.stream[0], scene.flow.stream[1]);
  const double spread = 4 * std::sqrt(scene.flow.nu * end);
  const double aside = std::min(std::max(7 * layer, 0.5 * size), spread),
               ahead = std::min(2 * layer, spread),
               behind = std::max(
                   aside, std::min(0.4 * speed * end + std::min(6 * layer, spread), 8 * size));
  if (speed == 0) return aside;
  const double with = (normal[0] * scene.flow.stream[0] + normal[1] * scene.flow.stream[1]) / speed;
  return aside + (with > 0 ? with * (behind - aside) : -with * (ahead - aside));
}

}  // namespace

flow::Warnings warnings_of_box(const VortexCase& scene) {
  if (!scene.merging.box || !scene.body || flow::fastest_of(scene) == 0) return {};
  constexpr std::array<Pair, 4> normals{{{-1, 0}, {0, -1}, {1, 0}, {0, 1}}};
  const std::array<double, 4>& box = *scene.merging.box;
  std::array<double, 4> right = box;
  for (int side = 0; side < 4; ++side) {
    const double out = side < 2 ? -1 : 1;
    for (const body::Body& one : flow::bodies_of(scene)) {
      const double edge =
          body::place_of(one, scene.time.end)[side] + out * far_enough(scene, normals[side]);
      if (out * right[side] < out * edge) right[side] = edge;
    }
  }
  if (right == box) return {};
  return {
      fmt::format("merging.box = [{:.4g}, {:.4g}, {:.4g}, {:.4g}] lets vorticity drift whose way "
                  "the body still "
                  "feels: the drag will be off by percents, or twice as large; [{:.3g}, {:.3g}, "
                  "{:.3g}, {:.3g}] keeps it to 1 %",
                  box[0], box[1], box[2], box[3], right[0], right[1], right[2], right[3])};
}

}  // namespace vortree::vortex
