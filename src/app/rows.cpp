#include "app/rows.hpp"

#include <algorithm>
#include <cmath>

namespace vortree::app {

/// Cubic through the four nearest entries of a table; NaN outside it.
double interpolated(const Column& x, const Column& y, double at) {
  if (x.size() < 4 || at < x.front() - 1e-9 || at > x.back() + 1e-9)
    return std::numeric_limits<double>::quiet_NaN();
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

double Rows::largest(std::optional<double> from, const Value& value) const {
  double most = -unseen;
  for (std::size_t r : rows(from)) most = std::max(most, std::abs(value(r)));
  return most < 0 ? unseen : most;
}

double Rows::rms(std::optional<double> from, const Value& value) const {
  double sum = 0, count = 0;
  for (std::size_t r : rows(from)) {
    const double one = value(r);
    if (std::isnan(one)) continue;  // beyond what a table has
    sum += one * one;
    ++count;
  }
  return count == 0 ? unseen : std::sqrt(sum / count);
}

std::vector<std::size_t> Rows::rows(std::optional<double> from) const {
  std::vector<std::size_t> result;
  for (std::size_t r = 0; r < T_.size(); ++r)
    if (T_[r] >= from.value_or(0) - 1e-9) result.push_back(r);
  return result;
}

void add(std::vector<Verdict>& list, const char* what, std::optional<double> asked,
         const std::function<double()>& reached) {
  if (asked) list.push_back({what, *asked, reached()});
}

}  // namespace vortree::app
