#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "checks/checks.hpp"
#include "flow/solver.hpp"

namespace vortree::app {

/// Numbers of a whole run, over all its resumptions.
struct Totals {
  double particle_steps = 0, most_particles = 0, seconds = 0, processor_seconds = 0;

  void save(flow::State& state) const;
  void restore(const flow::State& state);
};

/// The text of summary.json, what it says of a finished run: the scene, steps and particles at the
/// end, totals, what the method says at its close, and how it was checked: asked, reached, passed
/// and status of each; what was not reached has null for both and says why. The seconds of the
/// phases are read from report.csv in `folder`.
std::string summary(const io::Scene& scene, const std::filesystem::path& folder,
                    const flow::Solver& solver, std::span<const std::string> phases,
                    const Totals& totals, std::span<const checks::Verdict> verdicts);

}  // namespace vortree::app
