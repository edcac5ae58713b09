#include "app/commands/sums/origin.hpp"

#include <cstdint>

#include "app/install_paths.hpp"
#include "io/quote.hpp"

namespace vortree::app {

io::Attributes origin_of(const std::string& said, const std::filesystem::path& input,
                         std::size_t particles) {
  constexpr std::size_t longest = 30000;  // HDF5 keeps all attributes of an object in 64 KiB
  return {{"version", version()},
          {"command_line", io::shortened(said, longest)},
          {"input", io::shortened(input.string(), longest / 4)},
          {"particles", static_cast<std::int64_t>(particles)}};
}

}  // namespace vortree::app
