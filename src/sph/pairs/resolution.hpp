#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "tree/order/points.hpp"

namespace vortree::sph {

/// Particles whose size may change: mass and reach.
///
/// root, path   where each comes from: the particle it once was part of, and which quarter of a
///              quarter ... of it, two bits a split below a leading one
struct Particles {
  std::vector<double> x, y, mass, reach;
  std::vector<std::uint32_t> root;
  std::vector<std::uint64_t> path;
  std::uint32_t roots = 0;

  [[nodiscard]] std::size_t size() const { return x.size(); }
  [[nodiscard]] tree::Points points() const { return {x, y}; }
  /// How often a particle was split.
  [[nodiscard]] int level(std::size_t i) const;
  /// Adds one that was never split.
  void add(double px, double py, double m, double r);
};

/// Splits chosen particles into four: a quarter of the mass, half the reach, on the corners of a
/// square of half the old spacing around the old place.
///
///   x +- spacing / 4,   spacing = spacing_of_reach reach
///
/// Conserves mass and its centre. The parts stand at the end, the whole is gone.
///
/// source  Khorasanizade & Sousa 2019, section 2.2 and figure 5
void split(Particles& particles, const std::function<bool(std::size_t)>& chosen,
           double spacing_of_reach = 1 / 3.9);

/// Merges four parts of one split, if all are there and chosen, into the particle they were: at
/// their centre of mass, mass added, reach doubled.
void merge(Particles& particles, const std::function<bool(std::size_t)>& chosen);

}  // namespace vortree::sph
