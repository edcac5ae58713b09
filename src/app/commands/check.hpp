#pragma once

#include <string>
#include <vector>

namespace vortree::app {

/// The scenes of cases/ with their titles, a line each; a scene that cannot be read is listed with
/// the reason.
std::string list_cases();

/// The scene with every default written out, as TOML; what is doubtful about it (warnings.hpp) goes
/// to standard error. throws io::InputError if it is not valid
std::string check(const std::string& scene, const std::vector<std::string>& overrides);

/// All keys that a scene may have, as the table of Markdown that cases/scenes.md shows.
std::string keys();

}  // namespace vortree::app
