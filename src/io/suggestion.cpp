#include "io/suggestion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace vortree::io {
namespace {

/// Levenshtein's distance, row by row.
std::size_t slips(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] != b[j]);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates) {
  std::string_view best;
  std::size_t fewest = std::max<std::size_t>(2, word.size() / 3) + 1;
  for (const std::string_view candidate : candidates) {
    const std::size_t n = slips(word, candidate);
    // Two slips turn any word of two letters into any other.
    if (n < fewest && n < std::max(word.size(), candidate.size())) {
      fewest = n;
      best = candidate;
    }
  }
  return best;
}

std::string listed(std::span<const std::string_view> words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

std::string listed(std::span<const std::string_view> words, std::string_view near) {
  constexpr std::size_t longest_list = 120, told = 5;
  std::string all = listed(words);
  if (all.size() <= longest_list) return all;
  std::vector<std::string_view> sorted(words.begin(), words.end());
  std::ranges::stable_sort(sorted, {}, [&](std::string_view word) { return slips(near, word); });
  return fmt::format("{} and {} more", listed(std::span(sorted).first(told)), sorted.size() - told);
}

}  // namespace vortree::io
