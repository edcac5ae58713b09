#include "sph/choice/warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "body/extent.hpp"

namespace vortree::sph {
namespace {

/// A layer of the thickness D/sqrt(Re) wants three spacings.
void doubt_spacing(flow::Warnings& list, const SphCase& scene) {
  const double length = body::length_of(*scene.body);
  const double reynolds = flow::fastest_of(scene) * length / scene.flow.nu;
  const double widest = length / std::sqrt(reynolds) / 3;
  if (scene.sph.spacing > widest)
    list.push_back(fmt::format(
        "sph.spacing = {:.3g}: at Re = {:.4g} the layer beside the body is {:.2g} thick; forces "
        "want {:.2g} or less",
        scene.sph.spacing, reynolds, 3 * widest, widest));
}

void doubt_motion(flow::Warnings& list, const SphSettings& own) {
  if (own.shift < 4)
    list.push_back(fmt::format(
        "sph.shift = {:.3g}: particles fall into disorder where fluid is strained; 6 holds",
        own.shift));
  if (own.courant > 0.5)
    list.push_back(fmt::format(
        "sph.courant = {:.3g}: particles pass each other in one step; 0.3 holds", own.courant));
}

void doubt_box(flow::Warnings& list, const SphCase& scene) {
  const double length = body::length_of(*scene.body);
  const auto [x, y] = scene.body->centre;
  const auto [x0, y0, x1, y1] = *scene.sph.box;
  const double room = std::min({x - x0, x1 - x, y - y0, y1 - y}) / length;
  const double wanted = scene.sph.outside == Outside::free ? 3 : 10;
  if (room < wanted)
    list.push_back(fmt::format(
        "sph.box is {:.2g} lengths of the body away from its centre; forces want {} or more", room,
        wanted));
}

}  // namespace

flow::Warnings warnings(const SphCase& scene) {
  flow::Warnings list;
  doubt_spacing(list, scene);
  doubt_motion(list, scene.sph);
  doubt_box(list, scene);
  return list;
}

}  // namespace vortree::sph
