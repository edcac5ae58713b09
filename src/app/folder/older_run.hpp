#pragma once

#include <filesystem>

namespace vortree::app {

/// Does the folder hold a run that could go on: a frames.h5 with frames, or a damaged one?
bool holds_frames(const std::filesystem::path& folder);

/// throws  io::InputError, with the ways out, if the folder holds what a new run would destroy:
///         frames, a frames.h5 of another origin, or tables, pictures, their xdmf, an outline or a summary
///         without frames. A run that was stopped before its first frame is no loss
void refuse_older_run(const std::filesystem::path& folder);

/// throws  io::InputError, with the ways out, if the table is there already and has rows
void refuse_older_table(const std::filesystem::path& table);

}  // namespace vortree::app
