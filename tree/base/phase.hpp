#pragma once

#include <functional>
#include <string_view>

namespace vortree::tree {

/// Told the name of each part of the work as it begins, for whoever keeps the time.
using Phase = std::function<void(std::string_view name)>;

}  // namespace vortree::tree
