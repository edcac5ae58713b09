#include "fmm/sources.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "fmm/geometry/bounds.hpp"
#include "fmm/geometry/units.hpp"
#include "fmm/losses/closeness.hpp"
#include "tree/base/told.hpp"
#include "tree/order/points.hpp"

namespace vortree::fmm {
namespace {

void check_length(const char* name, std::size_t found, std::size_t expected) {
  if (found != expected) {
    throw std::invalid_argument(std::string(name) + " has " + std::to_string(found) +
                                " values, x has " + std::to_string(expected));
  }
}

using tree::told;

std::string complaint(const char* name, std::size_t i, double value, const std::string& wish) {
  return std::string(name) + "[" + std::to_string(i) + "] is " + told(value) + "; it must be " +
         wish;
}

[[noreturn]] void refuse(const char* name, std::size_t i, double value, const std::string& wish) {
  throw std::invalid_argument(complaint(name, i, value, wish));
}

void check_within(const char* name, std::span<const double> values, const Bounds& bounds,
                  double most) {
  if (bounds.within(-most, most)) return;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) refuse(name, i, values[i], "finite");
    if (std::abs(values[i]) > most) {
      refuse(name, i, values[i], "at most " + told(most) + " in magnitude");
    }
  }
}

constexpr double largest_double = std::numeric_limits<double>::max();

void check_cores(std::span<const double> sigma, const Bounds& bounds, std::size_t n) {
  if (sigma.empty()) return;
  check_length("sigma", sigma.size(), n);
  if (bounds.within(0.0, largest_double)) return;
  for (std::size_t i = 0; i < n; ++i) {
    if (!(std::isfinite(sigma[i]) && sigma[i] >= 0.0)) {
      refuse("sigma", i, sigma[i], "finite and >= 0");
    }
  }
}

/// Under cores that are so many times as wide no two blobs are too near to each other.
constexpr double wide_enough = 1e20;

void check_distances(const Sources& sources, const SourceBounds& bounds, const Units& units) {
  const double limit = Units::least_length / units.per_length;
  if (!sources.sigma.empty() && bounds.sigma.low >= wide_enough * limit) return;
  const double least = std::min(bounds.x.least_magnitude, bounds.y.least_magnitude);
  const auto near = find_close_pair(sources.x, sources.y, least, limit);
  if (!near) return;
  throw std::invalid_argument("blobs " + std::to_string(near->first) + " and " +
                              std::to_string(near->second) + " are " + told(near->distance) +
                              " apart; of an extent like that of all blobs, " +
                              told(1 / units.per_length) + ", doubles resolve " + told(limit));
}

/// Cores so wide that they count as less wide must not move what others leave alone.
void check_wide_cores(const Sources& sources, const SourceBounds& bounds, const Units& units) {
  const double widest = std::sqrt(Units::largest_core) / units.per_length;
  if (bounds.sigma.within(0.0, widest)) return;
  double weak = 0.0, strong = 0.0;
  std::size_t first = sources.size();
  for (std::size_t i = 0; i < sources.sigma.size(); ++i) {
    const double gamma = std::abs(units.circulation(sources.gamma[i]));
    if (sources.sigma[i] > widest) {
      if (gamma > 0.0) first = std::min(first, i), weak += gamma / Units::largest_core;
    } else {
      strong = std::max(strong, gamma / std::max(1.0, units.squared_core(sources.sigma[i])));
    }
  }
  if (weak > 0x1p-53 * strong) {
    refuse("sigma", first, sources.sigma[first],
           "at most " + told(widest) + ", 1e60 times the extent of the blobs");
  }
}

}  // namespace

Units check(const Sources& sources) {
  return check(sources, SourceBounds::of(sources));
}

Units check(const Sources& sources, const SourceBounds& bounds) {
  check_length("y", sources.y.size(), sources.size());
  check_length("gamma", sources.gamma.size(), sources.size());
  check_within("x", sources.x, bounds.x, tree::largest_coordinate);
  check_within("y", sources.y, bounds.y, tree::largest_coordinate);
  check_within("gamma", sources.gamma, bounds.gamma, largest_double);
  check_cores(sources.sigma, bounds.sigma, sources.size());
  const Units units = Units::of(bounds);
  check_distances(sources, bounds, units);
  check_wide_cores(sources, bounds, units);
  return units;
}

std::string complain_of_cores(std::span<const double> sigma, const Units& units, bool wide) {
  return complain_of_cores(sigma, bounds_of(sigma), units, wide);
}

std::string complain_of_cores(std::span<const double> sigma, const Bounds& bounds,
                              const Units& units, bool wide) {
  const double least = Units::least_length / units.per_length;
  const double widest = wide ? std::sqrt(Units::largest_core) / units.per_length : largest_double;
  const bool fit = bounds.all_numbers && bounds.least_magnitude >= least;
  if (fit && bounds.high <= widest) return {};
  const auto found = std::ranges::find_if(
      sigma, [&](double value) { return value > widest || (value < least && value != 0.0); });
  if (found == sigma.end()) return {};
  return complaint("sigma", static_cast<std::size_t>(found - sigma.begin()), *found,
                   "0 or at least " + told(least) + (wide ? " and at most " + told(widest) : "") +
                       " for a gradient or a stream function of blobs of this extent");
}

void check(const Targets& targets) {
  check_length("y", targets.y.size(), targets.size());
  check_within("x", targets.x, bounds_of(targets.x), largest_double);
  check_within("y", targets.y, bounds_of(targets.y), largest_double);
  check_cores(targets.sigma, bounds_of(targets.sigma), targets.size());
}

void check_result(std::size_t n, std::span<const double> u, std::span<const double> v) {
  if (u.size() == n && v.size() == n) return;
  throw std::invalid_argument("u has " + std::to_string(u.size()) + " values and v " +
                              std::to_string(v.size()) + "; both must have " + std::to_string(n));
}

void check_result(std::size_t n, const char* name, std::span<const double> values) {
  if (values.size() == n) return;
  throw std::invalid_argument(std::string(name) + " has " + std::to_string(values.size()) +
                              " values; it must have " + std::to_string(n));
}

}  // namespace vortree::fmm
