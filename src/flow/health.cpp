#include "flow/health.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vortree::flow {
namespace {

constexpr std::size_t many_blobs = 20'000, many_of_late = 5000, many_a_panel = 100;
constexpr double most_vorticity = 100;  // of both signs, in U D

}  // namespace

void Growth::add(std::size_t blobs) {
  counts_.push_back(blobs);
  if (counts_.size() > 6) counts_.pop_front();
}

std::size_t Growth::most(double time) const {
  const vortex::Problem& p = flow_.problem;
  const auto times = [&](double usual) { return static_cast<std::size_t>(flow_.crowding * usual); };
  const std::size_t ceiling = std::min(most_blobs, flow_.held_blobs), many = times(many_blobs),
                    before = counts_.back(), split = p.splitting.children * before;
  if (!flow_.wall && !flow_.splits_endlessly)
    return std::min(ceiling, std::max(many, p.splitting.children * split));
  if (p.merging.tolerance == 0)  // asked for
    return std::min(ceiling, std::max(many_blobs, split));
  if (flow_.wall && time < 10.5 * p.dt)
    return std::min(ceiling,
                    std::max(many, 3 * before + times(many_a_panel * flow_.wall->panels())));
  const bool settled = counts_.size() == 6 && !(flow_.wall && time < 12.5 * p.dt);
  const std::size_t soon = std::max(many, 3 * before),
                    later = settled ? std::max(times(many_of_late), 3 * counts_.front()) : soon;
  return std::min({ceiling, soon, later});
}

std::string multiplied(std::size_t blobs, std::size_t before, const FlowCase& flow) {
  const std::string counts = fmt::format("{} blobs after {}: ", blobs, before);
  if (blobs > flow.held_blobs)
    return counts + fmt::format("the machine's memory holds {}", flow.held_blobs);
  if (flow.problem.merging.tolerance == 0)
    return counts + "they split and never merge; merging.tolerance above 0 keeps them few";
  return counts + "they multiply faster than they merge" +
         (flow.splits_endlessly
              ? ", since a step widens them by more than splitting makes up for; larger "
                "cores.sigma_max or smaller time.dt"
              : "; larger merging.tolerance or merging.reach, or smaller time.dt");
}

std::string not_finite(const io::Frame& frame) {
  for (const auto& [name, column] :
       {std::pair{"x", &frame.x}, std::pair{"y", &frame.y}, std::pair{"gamma", &frame.gamma},
        std::pair{"sigma", &frame.sigma}, std::pair{"u", &frame.u}, std::pair{"v", &frame.v}}) {
    const auto bad = std::ranges::find_if(*column, [](double a) { return !std::isfinite(a); });
    if (bad != column->end())
      return fmt::format("{} of blob {} of {} is {}", name, bad - column->begin(), column->size(),
                         *bad);
  }
  return "";
}

std::string broken(const vortex::Blobs& blobs, const FlowCase& flow, double time) {
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

}  // namespace vortree::flow
