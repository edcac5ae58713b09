#include "checks/convergence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace vortree::checks {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

bool usable(double a) {
  return std::isfinite(a) && a > 0;
}

}  // namespace

std::vector<double> orders(std::span<const double> h, std::span<const double> e) {
  assert(h.size() == e.size());
  std::vector<double> p(h.size(), unknown);
  for (std::size_t i = 1; i < h.size(); ++i)
    if (usable(h[i]) && usable(h[i - 1]) && usable(e[i]) && usable(e[i - 1]) && h[i] != h[i - 1] &&
        e[i] != e[i - 1])
      p[i] = std::log(e[i] / e[i - 1]) / std::log(h[i] / h[i - 1]);
  return p;
}

double fitted_order(std::span<const double> h, std::span<const double> e) {
  assert(h.size() == e.size());
  double n = 0, x = 0, y = 0, xx = 0, xy = 0, first = 0;
  bool change = false;
  for (std::size_t i = 0; i < h.size(); ++i) {
    if (!usable(h[i]) || !usable(e[i])) continue;
    const double a = std::log(h[i]), b = std::log(e[i]);
    if (n == 0) first = e[i];
    change = change || e[i] != first;
    n += 1;
    x += a;
    y += b;
    xx += a * a;
    xy += a * b;
  }
  const double spread = n * xx - x * x;
  return n >= 2 && change && spread > 1e-12 * n * xx ? (n * xy - x * y) / spread : unknown;
}

std::string text_table(std::span<const std::string> headings,
                       std::span<const std::vector<std::string>> rows) {
  std::vector<std::size_t> width;
  for (const std::string& heading : headings) width.push_back(heading.size());
  for (const auto& row : rows)
    for (std::size_t c = 0; c < width.size(); ++c) width[c] = std::max(width[c], row[c].size());
  std::string text;
  const auto add = [&](std::span<const std::string> cells) {
    for (std::size_t c = 0; c < width.size(); ++c)
      text += fmt::format("{:>{}}{}", cells[c], width[c], c + 1 < width.size() ? "  " : "\n");
  };
  add(headings);
  for (const auto& row : rows) add(row);
  return text;
}

}  // namespace vortree::checks
