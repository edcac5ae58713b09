#pragma once

#include <span>
#include <string>

namespace vortree::app {

/// Draws what the folder of a run or a bench has figures of; says which cannot be drawn.
/// formats  of figure_formats(); none: png
/// throws  io::InputError if there is nothing to draw
void plot_folder(const std::string& folder, std::span<const std::string> formats);

}  // namespace vortree::app
