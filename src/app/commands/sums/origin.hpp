#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "io/tables/particles.hpp"

namespace vortree::app {

/// Where the numbers of an output come from, as attributes of its HDF5 file: version,
/// command_line, input and particles, how many it has.
///
/// said   the command line; of a longer one than an attribute holds, beginning and end
[[nodiscard]] io::Attributes origin_of(const std::string& said, const std::filesystem::path& input,
                                       std::size_t particles);

}  // namespace vortree::app
