#pragma once

#include <filesystem>
#include <string_view>

#include "flow/warnings.hpp"
#include "io/scene/scene.hpp"

// The files that a scene's [check] is held against.

namespace vortree::io {

/// Stands for the value of flow.reynolds in the name of a reference file.
inline constexpr std::string_view by_reynolds = "{reynolds}";

/// Where a reference file of [check] lies: relative to the folder of the scene file.
[[nodiscard]] std::filesystem::path reference_path(const Scene&, std::string_view written);

/// Whether a reference is named by the Reynolds number, and has files of that name for others, but
/// none for that of the scene: then what is held against it is not reached.
[[nodiscard]] bool lacks_reference(const Scene&, std::string_view written);

/// throws  InputError if there is no such file, with a name beside it that is nearly the same
void require_reference_file(const std::filesystem::path&);

/// A reference of another flow: a note of its file, a line that begins with #, says `Re = 20` (or
/// `Re = U D/nu = 20`) and the flow has a Reynolds number that differs by more than a hundredth.
[[nodiscard]] flow::Warnings doubt_references(const Scene&);

}  // namespace vortree::io
