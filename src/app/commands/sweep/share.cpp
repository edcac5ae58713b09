#include "app/commands/sweep/share.hpp"

#include <fmt/format.h>

#include <charconv>
#include <stdexcept>

#include "io/input_error.hpp"
#include "io/quote.hpp"

namespace vortree::app {
namespace {

/// 0 if it is no number.
std::size_t count_in(std::string_view word) {
  std::size_t count = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), count);
  return error == std::errc{} && end == word.data() + word.size() ? count : 0;
}

}  // namespace

Share share_in(const std::string& word) {
  const std::size_t slash = word.find('/');
  const Share share{count_in(word.substr(0, slash)),
                    slash == std::string::npos ? 0 : count_in(word.substr(slash + 1))};
  if (share.task == 0 || (slash != std::string::npos && share.task > share.tasks))
    throw std::invalid_argument(fmt::format(
        "{}: expected K/N, task K of N with K from 1 to N, or K, one run of the list from 1 on",
        io::shortened(word, 40)));
  return share;
}

std::vector<std::size_t> runs_of(const Share& share, std::size_t runs) {
  if (share.tasks == 0 && share.task > runs)
    throw io::InputError(fmt::format("command line: --only {}: the list has {} run{}", share.task,
                                     runs, runs == 1 ? "" : "s"));
  std::vector<std::size_t> own;
  const std::size_t stride = share.tasks == 0 ? runs : share.tasks;
  for (std::size_t k = share.task - 1; k < runs; k += stride) own.push_back(k);
  return own;
}

}  // namespace vortree::app
