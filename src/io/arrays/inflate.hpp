#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "io/arrays/array_file.hpp"

namespace vortree::io {

/// Unpacks deflated bytes (RFC 1951, as zip files have them) of which `size` are to come out.
///
/// throws  BadArray if they are damaged, if another number comes out, if so few cannot hold so
///         many, or if the program was built without zlib; h5::NotTheFile if there is no memory
[[nodiscard]] std::string inflated(std::string_view packed, std::uint64_t size);

}  // namespace vortree::io
