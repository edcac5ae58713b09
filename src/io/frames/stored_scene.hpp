#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "flow/method.hpp"
#include "io/frames/frames.hpp"
#include "io/scene/scene.hpp"

namespace vortree::io {

/// What a frames file is to tell of the run of a scene.
///
/// version  of the program
[[nodiscard]] RunInfo info_of(const Scene&, std::string version);

/// The scene that a frames file was written by.
///
/// file     the frames file
/// path     that the scene had: errors name it, files that it names are relative to its folder
/// throws   InputError, with the name of the frames file, if it does not say
[[nodiscard]] Scene stored_scene(const RunInfo&, const std::filesystem::path& file,
                                 const std::filesystem::path& path, const flow::Methods&);

/// The same with other values of some keys.
///
/// throws   InputError as parse_scene, and if more than time.end, [output] and [check] differs
[[nodiscard]] Scene stored_scene(const RunInfo&, const std::filesystem::path& file,
                                 const std::filesystem::path& path, const flow::Methods&,
                                 std::span<const std::string> overrides);

/// The table, or key at the top, of the first difference between two scenes that would change the
/// flow; empty if there is none. What may change on the way is where a run ends, what it writes,
/// and what it is held against; that an accuracy was asked for does not count beside what was
/// chosen by it.
[[nodiscard]] std::string flow_difference(const Scene& a, const Scene& b);

/// throws  InputError if two scenes differ in more than may change on the way
void hold_scene(const Scene& was, const Scene& now, const std::filesystem::path& file);

/// throws  InputError if the time of a frame is not that of its step
void hold_time(const Frame&, double dt, const std::filesystem::path& file);

}  // namespace vortree::io
