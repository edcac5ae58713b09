#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "app/loop/run.hpp"
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
///
/// origin  lines `name: words`
std::string summary(const io::Scene& scene, const std::filesystem::path& folder,
                    const flow::Solver& solver, std::span<const std::string> phases,
                    const Totals& totals, std::span<const std::string> origin,
                    std::span<const checks::Verdict> verdicts);

/// What summary.json in a folder says of a run that has ended: the numbers of its RunResult, bit
/// for bit (of one that is not finite, that it is none). None if there is no summary.
/// throws  io::InputError if it is damaged, or an earlier version has written it
std::optional<RunResult> result_in(const std::filesystem::path& folder);

}  // namespace vortree::app
