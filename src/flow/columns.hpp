#pragma once

#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace vortree::flow {

/// One property of all particles, as frames and pictures show it: its name, and its unit as powers
/// of length L and time T ("L^2/T").
struct Column {
  std::string name, unit;
  std::vector<double> values{};
  bool operator==(const Column&) const = default;
};

using Columns = std::vector<Column>;

/// throws  std::out_of_range with the name, if there is none
inline const std::vector<double>& column(std::span<const Column> columns, std::string_view name) {
  for (const Column& one : columns)
    if (one.name == name) return one.values;
  throw std::out_of_range("no column " + std::string(name));
}

/// Whatever a flow needs, beside its columns, to go on bit for bit, by name.
using State = std::map<std::string, std::vector<double>>;

/// throws  std::out_of_range with the name, if there is none
inline const std::vector<double>& saved(const State& state, const std::string& name) {
  const auto found = state.find(name);
  if (found == state.end()) throw std::out_of_range("nothing saved of " + name);
  return found->second;
}

/// The same for a single number.
inline double saved_number(const State& state, const std::string& name) {
  const std::vector<double>& values = saved(state, name);
  if (values.size() != 1)
    throw std::out_of_range(name + " has " + std::to_string(values.size()) + " values, not one");
  return values.front();
}

}  // namespace vortree::flow
