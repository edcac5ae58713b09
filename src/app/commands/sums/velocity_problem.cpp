#include "app/commands/sums/velocity_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string>

#include "io/while_reading.hpp"

namespace vortree::app {
namespace {

io::ParticleFile read(const std::filesystem::path& file, io::ParticleColumns columns) {
  const io::WhileReading reading(file);
  return io::read_particles(file, columns);
}

io::ParticleFile read_sources(const VelocityJob& job) {
  using enum io::Need;
  io::ParticleFile sources = read(job.in, {.gamma = required, .sigma = optional});
  if (job.sigma) sources.sigma.assign(sources.x.size(), *job.sigma);
  return sources;
}

// Room for all that is asked for.
void make_room(VelocityProblem& problem, const VelocityJob& job) {
  const std::size_t m = problem.points().size();
  for (const Quantity& one : quantities_in(job.what)) {
    if (one.sum == nullptr) {
      problem.velocities = true;
      problem.u.resize(m);
      problem.v.resize(m);
      continue;
    }
    problem.others.push_back(one);
    problem.found.emplace_back(one.columns.size(), std::vector<double>(m));
  }
}

void require_cores(const VelocityProblem& problem, const VelocityJob& job) {
  const bool vorticity =
      std::ranges::find(problem.others, "vorticity", &Quantity::name) != problem.others.end();
  if (vorticity && problem.sources.sigma.empty())
    throw io::InputError(
        fmt::format("{}: bare vortices have no vorticity around them; cores were "
                    "expected, sigma of each or --sigma of all",
                    job.in.string()));
}

}  // namespace

bool asks_for_velocity(const VelocityJob& job) {
  return quantities_in(job.what).front().sum == nullptr;
}

VelocityProblem read_problem(const VelocityJob& job) {
  VelocityProblem problem;
  problem.sources = read_sources(job);
  problem.elsewhere = !job.targets.empty();
  if (problem.elsewhere) problem.targets = read(job.targets, {});
  make_room(problem, job);
  require_cores(problem, job);
  return problem;
}

std::vector<io::ParticleColumn> columns_of(const VelocityProblem& problem) {
  using Line = std::span<const double>;
  std::vector<io::ParticleColumn> columns;
  if (problem.velocities) columns = {{"u", Line(problem.u)}, {"v", Line(problem.v)}};
  for (std::size_t k = 0; k < problem.others.size(); ++k)
    for (std::size_t c = 0; c < problem.found[k].size(); ++c)
      columns.push_back({std::string(problem.others[k].columns[c]), Line(problem.found[k][c])});
  return columns;
}

}  // namespace vortree::app
