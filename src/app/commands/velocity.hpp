#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fmm/plan.hpp"

namespace vortree::app {

/// Every method by which `vortree velocity` can sum, best first.
std::vector<std::string> velocity_methods();

struct VelocityJob {
  std::filesystem::path in, out, targets;  // targets empty: the sources themselves
  std::string method = "fmm";
  fmm::Options options;
  bool verify = false;
  int repeat = 1;
};

/// line     what was done, as JSON on one line
/// missed   if asked to verify: why the tolerance was not kept, as one line
struct VelocityReport {
  std::string line;
  std::optional<std::string> missed;
};

/// Velocities upon all vortices of a particle file, or upon the points of another: reads, sums
/// `repeat` times, writes `u` and `v`.
///
/// returns  line: what was done, for standard output: n, method, builder, threads, tolerance,
/// order, pairs, peak_bytes, seconds
///          {tree, upward, far, near, total: medians of all repetitions; io} and, if asked to
///          verify, error {relative_l2, p99, max, targets, condition}. What a method does not have
///          is null.
/// throws   io::InputError for wrong files, std::invalid_argument for options that fmm::Plan
/// refuses
VelocityReport velocity(const VelocityJob& job);

}  // namespace vortree::app
