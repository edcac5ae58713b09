#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <vector>

#include "bench/tables/step_bench.hpp"

namespace vortree::app {

/// The flows whose steps `vortree bench step` measures, each as its scene has it and by these
/// settings instead:
///
///   boxes     velocity.method=boxes: series straight to the blobs
///   direct    velocity.method=direct: over all pairs
///   unmerged  merging.tolerance=0: blobs never merge
///
/// Each is made when it is asked for: a scene that comes with the program is followed until it is
/// in full swing (quick: less finely and not as far), or, past its first steps, has `largest`
/// blobs (0: any number).
///
/// runs     folders of runs: with their last frames in place of the scenes
/// throws   io::InputError, at once, if a folder holds no run by vortices with a good frame
std::vector<std::function<bench::StepFlow()>> step_flows(
    const std::vector<std::filesystem::path>& runs, bool quick, std::size_t largest);

}  // namespace vortree::app
