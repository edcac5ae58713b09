#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vortree::app {

/// What a figure can be saved as: a picture, or pages of vectors.
const std::vector<std::string>& figure_formats();

/// Draws every figure that the files of a run or a bench allow: runs each script of plots/ with the
/// folder and the formats as its arguments, one after another, all in one /usr/bin/python3.
///
/// plots/X.py draws X.png, or X.pdf, X.svg, into the folder and prints its name; where the folder
/// lacks what it needs, it writes nothing and leaves with 0. A figure shows the other files of its
/// folder, so that an older one of them is replaced.
///
/// kind     only scripts whose names begin with it: "neighbors", "trees", "velocity"
/// formats  of figure_formats(); none: png
/// returns  whether there was anything to draw
/// throws   io::InputError if there is no such folder, or a figure cannot stand there: no right to
///          write, something of that name that is no file, a link to a file of another suffix;
///          std::runtime_error that names the script and says why, if one fails
bool plot(const std::filesystem::path& folder, std::string_view kind = {},
          std::span<const std::string> formats = {});

/// Takes each line that a script writes on standard error, while it runs.
using Heard = std::function<void(std::string_view line)>;

/// Runs one script with words of its own. Its last line on standard error says what it has made, or
/// why it fails.
///
/// returns that line
/// throws   io::InputError with that line if it leaves with 2; std::runtime_error if with another
///         code than 0
std::string run_script(const std::filesystem::path& script, std::vector<std::string> words,
                       const Heard& heard);

/// The same in the place of this process, which it never returns to: what it says and how it ends
/// are its own.
/// throws   std::runtime_error if Python cannot be started
[[noreturn]] void become_script(const std::filesystem::path& script,
                                std::vector<std::string> words);

}  // namespace vortree::app
