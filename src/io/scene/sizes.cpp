#include "io/scene/sizes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <span>

#include "io/scene/schema.hpp"

namespace vortree::io {
namespace {

constexpr double largest = 1e30, least = 1e-30;

void hold_size(const Document& document, std::string_view name, double value) {
  const double size = std::abs(value);
  if (size == 0 || (size >= least && size <= largest)) return;
  document.refuse(name,
                  fmt::format("{} is {}; numbers of a size within {:.0e} .. {:.0e} are computed "
                              "with: other units of length and time bring it there",
                              name, value, least, largest));
}

/// The real numbers that a key has.
std::span<const double> numbers(const auto&) {
  return {};
}
std::span<const double> numbers(double* value) {
  return {value, 1};
}
std::span<const double> numbers(std::vector<double>* values) {
  return *values;
}
template <std::size_t n>
std::span<const double> numbers(std::array<double, n>* values) {
  return *values;
}
template <class T>
std::span<const double> numbers(std::optional<T>* value) {
  return *value ? numbers(&**value) : std::span<const double>{};
}

/// Refuses numbers out of proportion.
void hold_sizes(const Document& document, std::string_view name, const Key& key) {
  if (const auto* list = std::get_if<ListOfTables>(&key.target)) {
    for (std::size_t i = 0; i < list->size(); ++i)
      for (const Key& own : list->keys(i)) hold_sizes(document, name, own);
    return;
  }
  if (const auto* table = std::get_if<InnerTable>(&key.target)) {
    if (!table->present()) return;
    for (const Key& own : table->keys())
      hold_sizes(document, fmt::format("{}.{}", name, own.name), own);
    return;
  }
  const auto real = std::visit([](const auto& target) { return numbers(target); }, key.target);
  for (const double value : real) hold_size(document, name, value);
}

}  // namespace

void refuse_sizes(const Document& document, const Scene& given) {
  Scene scene = given;  // keys are places to write to, too
  for (const Key& key : keys(scene)) hold_sizes(document, key.name, key);
  for (const SceneTable& table : tables_that_count(scene)) {
    if (table.name == "check" || table.name == "output") continue;  // nothing is computed with
    if (!table.present()) continue;
    for (const Key& key : table.keys())
      hold_sizes(document, fmt::format("{}.{}", table.name, key.name), key);
    for (std::size_t k = 0; table.others && k < table.others->size(); ++k)
      for (const Key& key : table.others->keys(k))
        hold_sizes(document, fmt::format("{}[{}].{}", table.name, k + 1, key.name), key);
  }
}

}  // namespace vortree::io
