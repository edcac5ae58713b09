#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vortree::app {

/// from, to  as many times each, a pair a window; to < from is backward in time
/// spacing   of the tracers [L]; that of the pictures if not said
struct LyapunovJob {
  std::filesystem::path folder;
  std::vector<double> from, to;
  std::optional<double> spacing;
};

/// Finite-time Lyapunov exponents of the flow that a run has left pictures of
/// (flow/paths/lyapunov.hpp): reads fields.h5, writes lyapunov.h5, lyapunov.xdmf and lyapunov.png
/// into the folder, in place of older ones. Warns of pictures too far apart in time.
///
/// returns  what was done, a line a window
/// throws   io::InputError: no folder, no run, no pictures or fewer than four in it, pictures on
///          several grids, times that are not within theirs, pairs that are none or occur twice
std::string lyapunov(const LyapunovJob& job);

}  // namespace vortree::app
