#pragma once

#include <string>

namespace vortree::app {

/// Draws what the folder of a run or a bench has figures of; says which cannot be drawn.
/// throws  io::InputError if there is nothing to draw
void plot_folder(const std::string& folder);

}  // namespace vortree::app
