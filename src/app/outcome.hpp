#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "app/flow_case.hpp"
#include "io/scene.hpp"

namespace vortree::app {

/// One thing that [check] asks of a run: reached <= asked.
struct Verdict {
  std::string what;
  double asked, reached;
  bool passed() const { return reached <= asked; }  // NaN is not passed
};

/// A finished run held against its scene's [check]: reads report.csv and wall.csv in `folder`, and
/// the reference files that the scene names.
///
/// blobs  at the end
/// What the run was too short to show (no row in the asked interval) has reached infinity.
std::vector<Verdict> verdicts(const io::Scene& scene, const std::filesystem::path& folder,
                              const vortex::Blobs& blobs, const FlowCase& flow);

/// One line: `check passed: drag_max 0.9 % of 2 %, ...`.
std::string verdict_line(std::span<const Verdict> verdicts);

}  // namespace vortree::app
