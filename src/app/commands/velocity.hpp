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

/// in, targets   words of io::read_particles; targets empty: the sources themselves
/// what          a list of quantities_in()
/// sigma         core of all sources, whatever their file says
/// said          the command line, for the output to tell
struct VelocityJob {
  std::filesystem::path in, out, targets;
  std::string what = "velocity";
  std::optional<double> sigma;
  std::string said;
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

/// Velocities, and what else is asked for, upon all vortices of a particle file, or upon the points
/// of another: reads, sums `repeat` times, writes the columns of the quantities.
///
/// returns  line: what was done, for standard output: n, method, builder, threads, tolerance,
///          order, pairs, peak_bytes, seconds {tree, upward, far, near; then plan and each other
///          quantity; total: medians of all repetitions; io} and, if asked to verify, error
///          {relative_l2, p99, max, targets, condition}. What a method does not have, or what does
///          not come of a sum of velocities where none is asked for, is null.
/// throws   io::InputError for wrong files, std::invalid_argument for options that fmm::Plan
///          refuses, for the vorticity of bare vortices, for anything but velocities by the grid,
///          and to verify without velocities
VelocityReport velocity(const VelocityJob& job);

}  // namespace vortree::app
