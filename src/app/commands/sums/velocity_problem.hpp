#pragma once

#include <vector>

#include "app/commands/sums/quantities.hpp"
#include "app/commands/velocity.hpp"
#include "fmm/sources.hpp"
#include "io/tables/particles.hpp"

namespace vortree::app {

/// What `vortree velocity` sums, and what comes of it.
///
/// elsewhere   the targets are not the sources themselves
/// velocities  they are asked for; else u and v are empty
/// others      what is asked for beside velocities
/// found       the columns of each of them
struct VelocityProblem {
  io::ParticleFile sources, targets;
  bool elsewhere = false, velocities = false;
  std::vector<double> u, v;
  std::vector<Quantity> others;
  std::vector<std::vector<std::vector<double>>> found;

  fmm::Sources blobs() const { return {sources.x, sources.y, sources.gamma, sources.sigma}; }
  fmm::Targets points() const {
    const auto& at = elsewhere ? targets : sources;
    return {at.x, at.y, {}};
  }
};

[[nodiscard]] bool asks_for_velocity(const VelocityJob& job);

/// With room for all that is asked for.
/// throws  io::InputError as io::read_particles, and for the vorticity of bare vortices
[[nodiscard]] VelocityProblem read_problem(const VelocityJob& job);

/// All that was asked for, as a file has it; of the problem, which has to outlive them.
[[nodiscard]] std::vector<io::ParticleColumn> columns_of(const VelocityProblem& problem);

}  // namespace vortree::app
