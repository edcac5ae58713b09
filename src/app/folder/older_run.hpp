#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace vortree::app {

/// throws  io::InputError if there is no such folder, or no frames.h5 in it
void require_frames(const std::filesystem::path& folder);

/// Does the folder hold a run that could go on: a frames.h5 with frames, or a damaged one?
bool holds_frames(const std::filesystem::path& folder);

/// throws  io::InputError, with the ways out, if the folder holds what a new run would destroy:
///         frames, a frames.h5 of another origin, or tables, pictures, their xdmf, an outline or a
///         summary without frames. A run that was stopped before its first frame is no loss
void refuse_older_run(const std::filesystem::path& folder);

/// throws  io::InputError, with the ways out, if the table is there already and has rows
void refuse_older_table(const std::filesystem::path& table);

/// The same for figures, which show other files of their folder: where one stands without them, as
/// before a run begins, it is not ours to replace.
///
/// kind, formats  of the scripts that will draw, as for plot()
void refuse_older_figures(const std::filesystem::path& folder, std::string_view kind = {},
                          std::span<const std::string> formats = {});

/// Removes the figures that scripts of this kind have drawn there, in all formats.
void remove_older_figures(const std::filesystem::path& folder, std::string_view kind = {});

/// Removes what an older run has left beside its frames and summary: tables, pictures, figures,
/// movies and a page, which may be those of another flow, with which the new run has nothing in
/// common.
void remove_older_tables_and_pictures(const std::filesystem::path& folder);

/// A run with a body whose outline, which figures are drawn by, is not there: an earlier build made
/// it, or somebody has taken it away.
bool lacks_outline(const std::filesystem::path& folder);

}  // namespace vortree::app
