#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "io/input_error.hpp"

namespace vortree::io {

/// Columns of a particle file; equal lengths, or empty when the file lacks the column (or nobody
/// asked for it).
struct ParticleFile {
  std::vector<double> x, y, gamma, sigma, reach;
};

enum class Need { unused, optional, required };

/// Which columns a job reads beside x and y, which are always required.
struct ParticleColumns {
  Need gamma = Need::unused;
  Need sigma = Need::unused;
  Need reach = Need::unused;
};

/// Reads 1-D datasets from the root of an HDF5 file; any integer or floating-point type is
/// converted to double.
///
/// throws  InputError for: no such file, a folder, a pipe, not HDF5, damaged, numbers that lie in
///         another file or whose filter is missing (hdf5_inside.hpp), a required dataset missing,
///         not one-dimensional, not numbers, lengths that differ (which, how many), NaN or infinity
///         (dataset and index), sigma < 0, reach < 0, integers of 2^53 and more, of which doubles
///         hold only some
[[nodiscard]] ParticleFile read_particles(const std::filesystem::path&, ParticleColumns = {});

using Values = std::variant<std::span<const double>, std::span<const std::int64_t>,
                            std::span<const std::int32_t>>;

/// One dataset to be written under its name.
struct ParticleColumn {
  std::string name;
  Values values;
};

/// Attributes on the root of the file.
using Attributes =
    std::vector<std::pair<std::string, std::variant<double, std::int64_t, std::string>>>;

/// Writes the columns as 1-D datasets into a new HDF5 file; an older file of that name is replaced
/// only when all is written.
///
/// throws  InputError if the folder does not exist or cannot be written, std::runtime_error if
///         writing fails half-way
void write_columns(const std::filesystem::path&, std::span<const ParticleColumn>,
                   const Attributes& = {});

}  // namespace vortree::io
