#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/arrays/npy_header.hpp"

namespace vortree::io {

/// throws  BadArray, a sentence that begins with the name, unless a field is of integers or of
///         floating-point numbers of 4 or 8 bytes, whatever their byte order
void require_real(const NumpyField& field, const std::string& name);

/// One column of a field of an array of two dimensions; column 0 of one that has fewer.
///
/// bytes   the whole .npy file, of that header
/// throws  h5::NotTheFile if there is no memory for so many
[[nodiscard]] std::vector<double> npy_numbers(std::string_view bytes, const NpyHeader& header,
                                              const NumpyField& field, std::uint64_t column);

/// The .npy file, version 1.0, of an array of one dimension.
[[nodiscard]] std::string npy_of(std::span<const double>);
[[nodiscard]] std::string npy_of(std::span<const std::int64_t>);
[[nodiscard]] std::string npy_of(std::span<const std::int32_t>);

}  // namespace vortree::io
