#pragma once

#include <fmt/format.h>

#include <cstdio>

namespace vortree::app {

/// A line on standard error in the program's name. A terminal that is gone or a pipe that nobody
/// reads must not end a run: what cannot be said is not said.
template <class... Values>
void say(fmt::format_string<Values...> words, Values&&... values) {
  const std::string line = "vortree: " + fmt::format(words, std::forward<Values>(values)...) + "\n";
  std::fwrite(line.data(), 1, line.size(), stderr);
}

}  // namespace vortree::app
