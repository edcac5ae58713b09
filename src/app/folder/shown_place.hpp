#pragma once

#include <filesystem>
#include <string_view>

namespace vortree::app {

/// Where a page or a video of a run is to stand. A link there is followed, but only onto a file of
/// the same suffix, and never onto one of another kind in the folder of the run.
///
/// suffix  of the file, as ".html"
/// throws  io::InputError: another suffix, no such folder or no right to write there,
///         something that is no file, a link to what the output would destroy
void require_shown_place(const std::filesystem::path& out, std::string_view suffix,
                         const std::filesystem::path& run);

}  // namespace vortree::app
