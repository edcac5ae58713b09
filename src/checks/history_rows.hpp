#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "checks/checks.hpp"
#include "io/tables/table.hpp"

namespace vortree::checks {

using Series = std::vector<double>;

/// A deviation in one row of a report; none where there is nothing to compare with.
using Deviation = std::function<std::optional<double>(std::size_t row)>;

/// Cubic through the four nearest entries of a table; none outside it, or of fewer than four.
std::optional<double> interpolated(const Series& x, const Series& y, double at);

/// ours/known - 1; ours itself where known is zero.
double deviation(double ours, double known);
/// part/whole; the part itself where the whole is zero.
double share(double part, double whole);

/// The rows of a report from a time T on.
class HistoryRows {
 public:
  explicit HistoryRows(const std::filesystem::path& file) : table_(file), T_(table_.column("T")) {}

  Series column(std::string_view name) const { return table_.column(name); }
  const Series& T() const { return T_; }

  /// The largest absolute value, and the root of the mean square; NaN if one is.
  Reached largest(std::optional<double> from, const Deviation& value) const;
  Reached rms(std::optional<double> from, const Deviation& value) const;

  /// What has no number because the run has ended before.
  Reached too_short() const;

 private:
  Reached of_values(std::optional<double> from, const Deviation& value,
                    const std::function<double(const Series&)>& number) const;

  io::Table table_;
  Series T_;
};

/// The largest absolute value; NaN if one is.
double largest_of(const Series& values);

/// Adds the verdict if something was asked.
void add(std::vector<Verdict>& list, const char* what, std::optional<double> asked,
         const std::function<Reached()>& reached);

}  // namespace vortree::checks
