#pragma once

#include <filesystem>
#include <vector>

namespace vortree::io {

/// Points along an outline, from a file of one of three layouts (those that XFOIL reads):
///
///   two columns  x and y of a point a line
///   Selig        a line with a name, then two columns: from the trailing edge over one side to the
///                nose and back on the other
///   Lednicer     a line with a name, one with the two numbers of points of each side, then two
///                columns, both sides from the nose on
///
/// Numbers are parted by blanks, tabs or a comma; empty lines and lines that begin with # are
/// notes.
///
/// returns  x, y, x, y, ..., of Lednicer's in the order of Selig's
/// throws   InputError `file:line: ...`: no such file, nothing but a name, a line that is no two
///          finite numbers, counts that are not those of the points, and points that make no
///          outline (body::hold_points)
[[nodiscard]] std::vector<double> read_coordinates(const std::filesystem::path& file);

}  // namespace vortree::io
