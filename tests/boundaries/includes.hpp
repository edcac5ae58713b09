#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// Who may include whom. Dependencies run one way,
///
///   cases -> src -> fmm -> tree -> std,   src/sph -> tree,
///
/// src/vortex and src/sph never see each other, and this reads the `#include` lines of a source
/// tree for arrows against the stream.
namespace vortree::test {

/// One `#include` line: the file that holds it, relative to the root of the source tree, its line
/// number, the name between the marks, and whether those were quotes or angles.
struct Include {
  std::string file;
  int line = 0;
  std::string name;
  bool quoted = true;
};

/// The part of the house that a file belongs to: "tree", "vortex", "tests" ...; empty if none.
std::string part_of(std::string_view file);

/// All includes in the text of a file.
std::vector<Include> includes_in(const std::string& file, std::string_view text);

/// What is wrong with an include, as `file:line: words`; empty if it is allowed.
std::string objection(const Include& include);

/// The objections to all C++ files below a root (hidden and build folders left out), and their
/// number.
std::vector<std::string> objections_below(const std::filesystem::path& root, int& files_read);

}  // namespace vortree::test
