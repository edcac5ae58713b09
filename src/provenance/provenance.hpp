#pragma once

#include <string>
#include <vector>

namespace vortree {

/// Where numbers come from: lines "machine: ...", "compiler: ...", "flags: ...", "commit: ...",
/// "load: ...", "date: ...".
std::vector<std::string> provenance();

}  // namespace vortree
