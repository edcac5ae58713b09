#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "flow/scales.hpp"
#include "flow/solver.hpp"
#include "io/scene/scene.hpp"

namespace vortree::checks {

/// What a run came to in one respect: a number or, where it has none to show, why.
struct Reached {
  std::optional<double> value;
  std::string why{};
};

/// One thing that [check] asks of a run: reached <= asked. What the run was too short to show, or
/// what a reference has no values for, is not reached: neither passed nor missed.
struct Verdict {
  std::string what;
  double asked;
  Reached reached;

  bool passed() const { return reached.value && *reached.value <= asked; }
  bool missed() const { return reached.value && !passed(); }  // NaN is
};

/// A finished run held against its scene's [check]: reads report.csv, wall.csv and energy.csv in
/// `folder`, and the reference files that the scene names. What is relative to something that is
/// zero counts as it is.
///
/// solver  the flow at the end
std::vector<Verdict> verdicts(const io::Scene& scene, const std::filesystem::path& folder,
                              const flow::Solver& solver, const flow::Scales& scales);

/// One line: `check passed: drag_max 0.009 of 0.02; not reached: bubble_max (the run ends at T =
/// 1)`.
std::string verdict_line(std::span<const Verdict> verdicts);

}  // namespace vortree::checks
