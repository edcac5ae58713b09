#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "bench/measures/anchors.hpp"
#include "bench/measures/measure.hpp"

namespace vortree::bench {

/// What a row of the velocity bench is about.
struct VelocityRow {
  std::string_view set, method;
  std::size_t n;
  std::optional<double> tolerance;
  int threads;
};

/// Least seconds that the machine would need; nothing where a method does not tell its work.
///
///   near   half a division or 4 fused operations a bare pair and direction, 18 fused ones a cored
///          pair, 4 a term of box-to-point series: both directions of a pair share 1/r^2, an
///          exponential takes a polynomial of degree 11. In floats where Work says so.
///   tree   120 bytes a blob to memory and back: keys, sorting, points in their new order
struct Floors {
  std::optional<double> near, tree;
};
Floors floors(const VelocityRow& row, const Measurement& made, const Anchors& machine);

/// As VelocityBench says.
std::string csv_header();
std::string csv_line(const VelocityRow& row, const Measurement& made, const Floors& floors);

/// For people: speed, error, and how much of the near sums' time the floor is.
std::string spoken_header();
std::string spoken_line(const VelocityRow& row, const Measurement& made, const Floors& floors);

}  // namespace vortree::bench
