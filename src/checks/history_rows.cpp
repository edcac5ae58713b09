#include "checks/history_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vortree::checks {

std::optional<double> interpolated(const Series& x, const Series& y, double at) {
  if (x.size() < 4 || at < x.front() - 1e-9 || at > x.back() + 1e-9) return std::nullopt;
  const auto above = std::ranges::upper_bound(x, at) - x.begin();
  const auto first = std::clamp<std::ptrdiff_t>(above - 2, 0, std::ssize(x) - 4);
  double sum = 0;
  for (auto i = first; i < first + 4; ++i) {
    double weight = 1;
    for (auto k = first; k < first + 4; ++k)
      if (k != i) weight *= (at - x[k]) / (x[i] - x[k]);
    sum += weight * y[i];
  }
  return sum;
}

double deviation(double ours, double known) {
  return known == 0 ? ours : ours / known - 1;
}

double share(double part, double whole) {
  return whole == 0 ? part : part / whole;
}

double largest_of(const Series& values) {
  double most = 0;
  for (const double value : values) {
    if (std::isnan(value)) return value;
    most = std::max(most, std::abs(value));
  }
  return most;
}

Reached HistoryRows::too_short() const {
  return {.value = {},
          .why = T_.empty() ? "the report has no rows"
                            : fmt::format("the run ends at T = {:.6g}", T_.back())};
}

Reached HistoryRows::of_values(std::optional<double> from, const Deviation& value,
                               const std::function<double(const Series&)>& number) const {
  Series values;
  bool any = false;
  for (std::size_t r = 0; r < T_.size(); ++r) {
    if (T_[r] < from.value_or(0) - 1e-9) continue;
    any = true;
    if (const auto one = value(r)) values.push_back(*one);
  }
  if (!any) return too_short();
  if (values.empty()) return {.value = {}, .why = "the reference has no values for these times"};
  return {.value = number(values)};
}

Reached HistoryRows::largest(std::optional<double> from, const Deviation& value) const {
  return of_values(from, value, largest_of);
}

Reached HistoryRows::rms(std::optional<double> from, const Deviation& value) const {
  return of_values(from, value, [](const Series& values) {
    double sum = 0;
    for (const double one : values) sum += one * one;
    return std::sqrt(sum / static_cast<double>(values.size()));
  });
}

void add(std::vector<Verdict>& list, const char* what, std::optional<double> asked,
         const std::function<Reached()>& reached) {
  if (asked) list.push_back({what, *asked, reached()});
}

}  // namespace vortree::checks
