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

/// What a file is read or written as, by its suffix; hdf5 for all that is none of the others.
enum class ParticleFormat { hdf5, csv, npy, npz };
[[nodiscard]] ParticleFormat format_of(const std::filesystem::path&);

/// The file that a word of read_particles leads to: FILE itself, or where the frame lies.
[[nodiscard]] std::filesystem::path file_behind(const std::filesystem::path& word);

/// Reads columns of numbers, of any integer or floating-point type, as doubles:
///
///   FILE        HDF5: 1-D datasets at its root
///   FILE.csv    a line of names, then rows (Table)
///   FILE.npy    n rows of x, y and those columns that the job reads, gamma, sigma, reach, in this
///               order, or of the first of them; or n records with such names
///   FILE.npz    1-D arrays, stored or deflated
///   FILE::12    a frame of a run's frames.h5, counted from 0; FILE::last; DIR::last
///
/// In HDF5 and .npz positions may be n x 2 in one, `points` or, without y, `x`; a single number
/// `sigma` or `reach` is that of all.
///
/// throws  InputError for: no such file, a folder, a pipe, another kind of file, damaged, numbers
///         that lie in another file or whose filter is missing (hdf5_inside.hpp), a required column
///         missing, another shape, not real numbers, lengths that differ (which, how many) or that
///         the file cannot hold, NaN or infinity (column and index), sigma < 0, reach < 0, integers
///         of 2^53 and more, of which doubles hold only some
[[nodiscard]] ParticleFile read_particles(const std::filesystem::path&, ParticleColumns = {});

using Values = std::variant<std::span<const double>, std::span<const std::int64_t>,
                            std::span<const std::int32_t>>;

/// One column to be written under its name.
struct ParticleColumn {
  std::string name;
  Values values;
};

/// Attributes on the root of the file.
using Attributes =
    std::vector<std::pair<std::string, std::variant<double, std::int64_t, std::string>>>;

/// throws  InputError if a name cannot be that of an output: .npy files hold one array
void require_writable_format(const std::filesystem::path&);

/// Writes the columns into a new file of the format that its name has: 1-D datasets of HDF5, 1-D
/// arrays of an .npz, or a .csv, every number in the shortest form that reads back to the same
/// double. An older file of that name is replaced only when all is written.
///
/// about   written into HDF5 alone
/// throws  InputError if the folder does not exist or cannot be written, or for more than an .npz
///         holds; std::invalid_argument for columns of a .csv of unequal lengths;
///         std::runtime_error if writing fails half-way
void write_columns(const std::filesystem::path&, std::span<const ParticleColumn>,
                   const Attributes& = {});

}  // namespace vortree::io
