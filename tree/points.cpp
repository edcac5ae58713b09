#include "tree/points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace vortree::tree {

namespace {

struct Extent {
  double low, high;
};

[[noreturn]] void refuse_coordinate(char axis, std::size_t index, double value) {
  std::ostringstream text;
  text.precision(17);
  text << "enclose: " << axis << "[" << index << "] is " << value
       << "; coordinates must be finite and at most " << largest_coordinate << " in magnitude";
  throw std::invalid_argument(text.str());
}

bool acceptable(double value) {
  return std::abs(value) <= largest_coordinate;
}

// Eight independent minima and maxima: a single one would be a chain of dependent operations.
Extent extent(char axis, std::span<const double> values) {
  constexpr std::size_t lanes = 8;
  std::array<double, lanes> low, high;
  low.fill(values[0]);
  high.fill(values[0]);
  std::array<std::uint64_t, lanes> refused{};
  const std::size_t whole = values.size() / lanes * lanes;
  for (std::size_t i = 0; i < whole; i += lanes) {
    for (std::size_t k = 0; k < lanes; ++k) {
      const double v = values[i + k];
      low[k] = v < low[k] ? v : low[k];
      high[k] = v > high[k] ? v : high[k];
      refused[k] |= !acceptable(v);
    }
  }
  for (std::size_t i = whole; i < values.size(); ++i) {
    low[0] = std::min(low[0], values[i]);
    high[0] = std::max(high[0], values[i]);
    refused[0] |= !acceptable(values[i]);
  }
  if (std::any_of(refused.begin(), refused.end(), [](auto flag) { return flag != 0; })) {
    const auto culprit = std::find_if_not(values.begin(), values.end(), acceptable);
    refuse_coordinate(axis, static_cast<std::size_t>(culprit - values.begin()), *culprit);
  }
  return {*std::min_element(low.begin(), low.end()), *std::max_element(high.begin(), high.end())};
}

// The next number of 20 significant bits above width, never nearer than 2^-20 of it.
double enlarge(double width) {
  int exponent;
  const double significand = std::frexp(width, &exponent);
  return std::ldexp(std::floor(std::ldexp(significand, 20)) + 2, exponent - 20);
}

double magnitude(Extent e) {
  return std::max(std::abs(e.low), std::abs(e.high));
}

}  // namespace

Domain enclose(Points points) {
  if (points.x.size() != points.y.size()) {
    throw std::invalid_argument("enclose: " + std::to_string(points.x.size()) + " x but " +
                                std::to_string(points.y.size()) + " y coordinates");
  }
  if (points.size() == 0) {
    return {};
  }
  const Extent x = extent('x', points.x);
  const Extent y = extent('y', points.y);
  const double farthest = std::max(magnitude(x), magnitude(y));
  if (farthest == 0) {
    return {};
  }
  const double width = std::max(x.high - x.low, y.high - y.low);
  return {x.low, y.low, enlarge(std::max({width, std::ldexp(farthest, -21), 0x1p-900}))};
}

}  // namespace vortree::tree
