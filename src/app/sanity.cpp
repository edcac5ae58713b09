#include "app/sanity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vortree::app {
namespace {

constexpr std::size_t most_blobs = 20'000'000, many_blobs = 20'000;
constexpr double most_vorticity = 100;  // of both signs, in U D

}  // namespace

std::string broken(const vortex::Blobs& blobs, std::size_t before, const FlowCase& flow,
                   double time) {
  // The first step, done in parts, makes many of the first sheet.
  const bool young = time < 10.5 * flow.problem.dt;
  const bool multiplied =
      blobs.size() > (young ? 5 : 1) * many_blobs && blobs.size() > (young ? 200 : 3) * before;
  if (blobs.size() > most_blobs || multiplied)
    return fmt::format(
        "{} blobs after {}: they multiply faster than they merge, since a step "
        "widens them by more than splitting makes up for; larger cores.sigma_max or "
        "smaller time.dt",
        blobs.size(), before);
  double strength = 0;
  for (std::size_t i = 0; i < blobs.size(); ++i) {
    if (!std::isfinite(blobs.x[i] + blobs.y[i] + blobs.gamma[i] + blobs.sigma[i]))
      return fmt::format("blob {} of {} is no longer finite", i, blobs.size());
    strength += std::abs(blobs.gamma[i]);
  }
  if (!flow.wall) return "";
  const double unit = flow.speed * flow.diameter, way = flow.speed * time / flow.diameter;
  if (strength > most_vorticity * unit * std::max(1.0, way / 10))
    return fmt::format(
        "the vorticity of both signs has grown to {:.3g} U D, which no flow of this "
        "kind has: time step, cores or panels are too coarse",
        strength / unit);
  return "";
}

}  // namespace vortree::app
