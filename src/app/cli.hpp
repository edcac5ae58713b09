#pragma once

#include <optional>
#include <string>

namespace vortree::app {

/// The whole program: reads the command line, carries the command out, reports an error as one line
/// on standard error.
///
/// returns  0 done; 1 the command failed; 2 wrong usage or input
int command_line(int argc, char** argv);

/// What is wrong with a command line, as a sentence; nothing if it could be carried out. Looks at
/// words only, not at the files that they name.
[[nodiscard]] std::optional<std::string> objection(int argc, const char* const* argv);

}  // namespace vortree::app
