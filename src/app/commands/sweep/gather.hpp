#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace vortree::app {

/// Makes of the runs in the folder of a sweep, by one task or several, what a sweep in one go
/// leaves: prints the table, writes sweep.csv and draws its figures, the same but for the seconds.
/// Runs that failed, are not at their ends or have not begun are gaps; the last line says which. It
/// may be asked while tasks are at work.
///
/// formats  of the figures; none: png
/// returns  0 if all runs came to their ends and missed no check, else 1
/// throws   io::InputError if no list is kept there, a run in the folder of one of the list is of
///          another scene or beyond its end, or sweep.csv leads to another file; nothing is written
///          then
int gather(const std::filesystem::path& folder, std::span<const std::string> formats = {});

}  // namespace vortree::app
