#include "app/commands/sums/quantities.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "fmm/vorticity.hpp"
#include "io/quote.hpp"

namespace vortree::app {
namespace {

void sum_gradient(const fmm::Plan& plan, const fmm::Sources&, const fmm::Targets& targets, double,
                  Quantity::Columns to) {
  plan.gradient(targets, to[0], to[1], to[2]);
}

void sum_stream_function(const fmm::Plan& plan, const fmm::Sources&, const fmm::Targets& targets,
                         double, Quantity::Columns to) {
  plan.stream_function(targets, to[0]);
}

void sum_vorticity(const fmm::Plan&, const fmm::Sources& sources, const fmm::Targets& targets,
                   double tolerance, Quantity::Columns to) {
  fmm::vorticity(sources, {targets.x, targets.y}, to[0], tolerance);
}

std::vector<std::string_view> words_of(std::string_view list) {
  std::vector<std::string_view> words;
  for (std::size_t comma; (comma = list.find(',')) != list.npos;) {
    words.push_back(list.substr(0, comma));
    list.remove_prefix(comma + 1);
  }
  words.push_back(list);
  return words;
}

std::vector<std::string_view> names() {
  std::vector<std::string_view> all;
  for (const Quantity& one : quantities()) all.push_back(one.name);
  return all;
}

}  // namespace

std::span<const Quantity> quantities() {
  static const std::vector<Quantity> all{{"velocity", {"u", "v"}, nullptr},
                                         {"gradient", {"ux", "uy", "vx"}, sum_gradient},
                                         {"stream_function", {"psi"}, sum_stream_function},
                                         {"vorticity", {"omega"}, sum_vorticity}};
  return all;
}

std::vector<Quantity> quantities_in(std::string_view list) {
  const std::vector<std::string_view> words = words_of(list), known = names();
  for (const std::string_view word : words) {
    const std::string shown = io::shortened(word, 40);
    if (std::ranges::find(known, word) == known.end())
      throw std::invalid_argument(fmt::format("{} not in {{{}}}", shown, fmt::join(known, ",")));
    if (std::ranges::count(words, word) > 1)
      throw std::invalid_argument(fmt::format("{} is there twice", shown));
  }
  std::vector<Quantity> asked;
  for (const Quantity& one : quantities())
    if (std::ranges::find(words, one.name) != words.end()) asked.push_back(one);
  return asked;
}

}  // namespace vortree::app
