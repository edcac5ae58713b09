#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <utility>

namespace vortree::app {

/// A line on standard error, in the program's name. What a terminal would obey is shown as \xNN,
/// what is longer than some 300 characters loses its middle: names, keys and values of the user
/// stand in such lines. A terminal that is gone or a pipe that nobody reads must not end a run:
/// what cannot be said is not said.
void say_line(std::string_view sentence);

template <class... Values>
void say(fmt::format_string<Values...> words, Values&&... values) {
  say_line(fmt::format(words, std::forward<Values>(values)...));
}

/// On standard output, of what also stands in a file: nobody need listen.
template <class... Values>
void tell(fmt::format_string<Values...> words, Values&&... values) {
  const std::string text = fmt::format(words, std::forward<Values>(values)...);
  std::fwrite(text.data(), 1, text.size(), stdout);
  std::fflush(stdout);
}

}  // namespace vortree::app
