#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "app/outcome.hpp"
#include "io/table.hpp"

namespace vortree::app {

constexpr double unseen = std::numeric_limits<double>::infinity();
using Column = std::vector<double>;
using Value = std::function<double(std::size_t row)>;

/// Cubic through the four nearest entries of a table; NaN outside it.
double interpolated(const Column& x, const Column& y, double at);

/// The rows of a report from a time T on.
class Rows {
 public:
  explicit Rows(const std::filesystem::path& file) : table_(file), T_(table_.column("T")) {}

  Column column(std::string_view name) const { return table_.column(name); }
  const Column& T() const { return T_; }

  /// The largest absolute value, or `unseen` without rows.
  double largest(std::optional<double> from, const Value& value) const;
  double rms(std::optional<double> from, const Value& value) const;

 private:
  std::vector<std::size_t> rows(std::optional<double> from) const;

  io::Table table_;
  Column T_;
};

/// Adds the verdict if something was asked.
void add(std::vector<Verdict>& list, const char* what, std::optional<double> asked,
         const std::function<double()>& reached);

}  // namespace vortree::app
