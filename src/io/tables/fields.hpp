#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "io/input_error.hpp"

namespace vortree::io {

/// Velocity, vorticity and, if the method tells them, stream function and pressure on a grid, for
/// pictures. x and y are the axes; u, v, omega, psi, p are row-major [y.size()][x.size()]. What is
/// not told, psi or p, is empty.
struct Field {
  double time = 0;
  std::vector<double> x, y, u, v, omega, psi{}, p{};
  bool operator==(const Field&) const = default;
};

/// Adds the group `field_<time>` with its checksum to DIR/fields.h5 (made if need be), and forces
/// it to the disk.
///
/// throws  std::invalid_argument if the sizes do not fit together or there is a field of that time,
///         std::runtime_error if it cannot be written
void append_field(const std::filesystem::path& dir, const Field&);

/// Times of the fields in DIR/fields.h5, ascending; empty if there is no such file.
/// throws  InputError if the file is not HDF5
[[nodiscard]] std::vector<double> field_times(const std::filesystem::path& dir);

/// throws  InputError if there is no field of that time, or if it is damaged
[[nodiscard]] Field read_field(const std::filesystem::path& dir, double time);

/// Drops the fields later than `time` (a resumed run will make them again) and those that cannot be
/// read or contradict their checksum; the file takes the place of the old one in one rename. Does
/// nothing without a file.
///
/// returns  the times of the fields that are kept, ascending
/// throws   std::runtime_error if the file cannot be written
std::vector<double> rewind_fields(const std::filesystem::path& dir, double time);

}  // namespace vortree::io
