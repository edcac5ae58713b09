#include "tree/order/points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

#include "tree/base/parallel.hpp"
#include "tree/base/told.hpp"
#include "tree/build/extent_kernel.hpp"

namespace vortree::tree {

namespace {

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

Extent extent(char axis, std::span<const double> values) {
  const std::size_t pieces = pieces_of(values.size());
  std::array<Extent, shared_pieces> found;
  for_each_piece(pieces, [&](std::size_t p) {
    const Range some = piece(values.size(), p, pieces);
    found[p] = kernel::extent(values.subspan(some.first, some.size()));
  });
  const Extent all = kernel::united({found.data(), pieces});
  if (!acceptable(all.low) || !acceptable(all.high)) {
    const auto culprit = std::find_if_not(values.begin(), values.end(), acceptable);
    refuse_coordinate(axis, static_cast<std::size_t>(culprit - values.begin()), *culprit);
  }
  return all;
}

// The next number of 20 significant bits above width, never nearer than 2^-20 of it.
double round_up(double width) {
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
  const Extent x = extent('x', points.x);  // what it refuses comes first
  return enclose(x, extent('y', points.y));
}

Domain enclose(Extent x, Extent y) {
  const double farthest = std::max(magnitude(x), magnitude(y));
  if (farthest == 0) {
    return {};
  }
  const double width = std::max(x.high - x.low, y.high - y.low);
  return {x.low, y.low, round_up(std::max({width, std::ldexp(farthest, -21), 0x1p-900}))};
}

Domain enlarge(const Domain& domain, double factor) {
  if (!(factor >= 1.0 && std::isfinite(domain.side * factor))) {
    throw std::invalid_argument("enlarge: factor is " + told(factor) +
                                "; it must be >= 1 and leave the side finite");
  }
  return {domain.x0, domain.y0, round_up(domain.side * factor)};
}

}  // namespace vortree::tree
