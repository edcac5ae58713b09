#include "vortex/health.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "base/rounded.hpp"
#include "vortex/tuning.hpp"

namespace vortree::vortex {

void Growth::add(std::size_t blobs) {
  counts_.push_back(blobs);
  if (counts_.size() > 6) counts_.pop_front();
}

std::size_t Growth::most(double time, const Setup& setup) const {
  const Problem& p = setup.problem;
  const auto times = [&](double usual) { return static_cast<std::size_t>(setup.crowding * usual); };
  const std::size_t ceiling = std::min(flow::most_particles, setup.held_blobs),
                    many = times(many_blobs), before = counts_.back(),
                    split = p.splitting.children * before;
  if (!setup.wall && p.splitting.scheme == SplitScheme::lattice)
    return std::min(ceiling, std::max(many, nodes_of_a_blob * before));
  if (!setup.wall && !setup.splits_endlessly)
    return std::min(ceiling, std::max(many, p.splitting.children * split));
  if (p.merging.tolerance == 0)  // asked for
    return std::min(ceiling, std::max(many_blobs, split));
  if (setup.wall && time < 10.5 * p.dt) {
    const std::size_t panels = setup.wall->panels();
    if (time < 1.5 * p.dt)
      return std::min(ceiling,
                      std::max({many, many_at_once, times(many_a_panel_at_once * panels)}));
    return std::min(ceiling,
                    std::max(many, too_many_times * before + times(many_a_panel * panels)));
  }
  const bool settled = counts_.size() == 6 && !(setup.wall && time < 12.5 * p.dt);
  const std::size_t soon = std::max(many, too_many_times * before),
                    later = settled
                                ? std::max(times(many_of_late), too_many_times * counts_.front())
                                : soon;
  return std::min({ceiling, soon, later});
}

std::string remedy(const Setup& setup) {
  const Problem& p = setup.problem;
  const double most = p.merging.sigma_max, alpha2 = p.splitting.alpha * p.splitting.alpha;
  if (setup.splits_endlessly)
    return ", since a step widens them by more than splitting makes up for; larger "
           "cores.sigma_max or smaller time.dt";
  if (alpha2 / (1 - alpha2) * 4 * p.flow.nu * p.dt > wide_children * most * most)
    return ", since what splits leaves children nearly too wide to merge; smaller "
           "splitting.alpha, larger cores.sigma_max or merging.cap";
  return setup.wall ? "; more body.panels or smaller time.dt"
                    : "; larger merging.tolerance or merging.reach, or smaller time.dt";
}

std::string multiplied(std::size_t blobs, std::size_t before, const Setup& setup) {
  const std::string counts =
      std::to_string(blobs) + " blobs after " + std::to_string(before) + ": ";
  if (blobs > setup.held_blobs)
    return counts + "the machine's memory holds " + std::to_string(setup.held_blobs);
  if (setup.problem.merging.tolerance == 0)
    return counts + "they split and never merge; merging.tolerance above 0 keeps them few";
  return counts + "they multiply faster than they merge" + remedy(setup);
}

std::string broken(const Blobs& blobs, const Setup& setup, double time) {
  double strength = 0;
  for (std::size_t i = 0; i < blobs.size(); ++i) {
    if (!std::isfinite(blobs.x[i] + blobs.y[i] + blobs.gamma[i] + blobs.sigma[i] + blobs.xx[i] +
                       blobs.xy[i]))
      return "blob " + std::to_string(i) + " of " + std::to_string(blobs.size()) +
             " is no longer finite";
    strength += std::abs(blobs.gamma[i]);
  }
  if (!setup.wall) return "";
  const double length = setup.scales.length, speed = setup.scales.speed;
  const double unit = speed * length, way = speed * time / length,
               bodies = std::max(1.0, setup.wall->perimeter() / (std::numbers::pi * length));
  if (strength > most_vorticity * unit * bodies * std::max(1.0, way / 10))
    return "the vorticity of both signs has grown to " + rounded(strength / unit, 3) +
           " U D, which no flow of this kind has: time step, cores or panels are too coarse";
  return "";
}

}  // namespace vortree::vortex
