#pragma once

#include <filesystem>
#include <string_view>

namespace vortree::app {

/// Draws every figure that the files of a run or a bench allow: runs each script of plots/ with the
/// folder as its one argument, one after another, all in one /usr/bin/python3.
///
/// A script writes its pictures into the folder and prints their names; where the folder lacks what
/// it needs, it writes nothing and leaves with 0.
///
/// kind    only scripts whose names begin with it: "neighbors", "trees", "velocity"
/// throws  io::InputError if there is no such folder; std::runtime_error that names the script
///         and says why, if one fails
void plot(const std::filesystem::path& folder, std::string_view kind = {});

}  // namespace vortree::app
