#pragma once

#include <nlohmann/json.hpp>

namespace vortree::app {

/// Members stay in the order in which they were written.
using Json = nlohmann::ordered_json;

}  // namespace vortree::app
