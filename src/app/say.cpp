#include "app/say.hpp"

#include <cstdio>
#include <string>

#include "io/quote.hpp"

namespace vortree::app {
namespace {

constexpr std::size_t longest_line = 330;

}  // namespace

void say_line(std::string_view sentence) {
  // Cut before and after: what is shown may take four times the bytes.
  const std::string shown = io::printable(io::shortened(sentence, 2 * longest_line));
  const std::string line = fmt::format("vortree: {}\n", io::shortened(shown, longest_line));
  std::fwrite(line.data(), 1, line.size(), stderr);
}

}  // namespace vortree::app
