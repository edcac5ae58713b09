#include "io/while_reading.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <string>

#include "io/quote.hpp"

namespace vortree::io {
namespace {

// What a handler may touch: made before anything can go wrong.
std::string last_words;
std::array<char, 1 << 16> spare_stack;

extern "C" void give_up(int) {
  const auto written = ::write(STDERR_FILENO, last_words.data(), last_words.size());
  ::_exit(written < 0 ? 1 : 2);
}

}  // namespace

WhileReading::WhileReading(const std::filesystem::path& file) {
  last_words = fmt::format("vortree: {}: the file is damaged: HDF5 itself fails on it\n",
                           printable(shortened(file.string(), 200)));
  stack_t spare{};
  spare.ss_sp = spare_stack.data();
  spare.ss_size = spare_stack.size();
  sigaltstack(&spare, nullptr);
  struct sigaction action {};
  action.sa_handler = give_up;
  action.sa_flags = SA_ONSTACK;
  for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &action, &before_[i]);
}

WhileReading::~WhileReading() {
  for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &before_[i], nullptr);
}

}  // namespace vortree::io
