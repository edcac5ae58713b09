#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "checks/checks.hpp"
#include "io/json.hpp"

namespace vortree::app {

/// Numbers of a whole run, over all its resumptions.
struct Totals {
  double particle_steps = 0, most_blobs = 0, seconds = 0, largest_drift = 0;
};

/// What summary.json says of a finished run: the scene, its `steps`, the `blobs` at the end,
/// totals, and how it was checked: asked, reached, passed and status of each; what was not reached
/// has null for both and says why. The seconds of the phases are read from report.csv in `folder`.
io::Json summary(const io::Scene& scene, const std::filesystem::path& folder, long steps,
                 std::size_t blobs, const Totals& totals,
                 std::span<const checks::Verdict> verdicts);

}  // namespace vortree::app
