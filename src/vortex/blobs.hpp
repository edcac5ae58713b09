#pragma once

#include <cstddef>
#include <vector>

#include "vortex/vec2.hpp"

namespace vortree::vortex {

/// Vortex blobs: the whole state of the vorticity field, copied, compared and saved as a value.
///
///   omega(x) = sum_j gamma_j / (pi sigma_j^2) exp(-|x - x_j|^2 / sigma_j^2)
///
/// x, y centres [m]; gamma circulation [m^2/s], anticlockwise positive; sigma core size [m].
struct Blobs {
  std::vector<double> x, y, gamma, sigma;

  std::size_t size() const { return x.size(); }
  Vec2 centre(std::size_t i) const { return {x[i], y[i]}; }
  void reserve(std::size_t n) {
    for (auto* column : {&x, &y, &gamma, &sigma}) column->reserve(n);
  }
  void resize(std::size_t n) {
    for (auto* column : {&x, &y, &gamma, &sigma}) column->resize(n);
  }
  void put(std::size_t i, Vec2 at, double circulation, double core) {
    x[i] = at.x;
    y[i] = at.y;
    gamma[i] = circulation;
    sigma[i] = core;
  }
  void append(Vec2 at, double circulation, double core) {
    x.push_back(at.x);
    y.push_back(at.y);
    gamma.push_back(circulation);
    sigma.push_back(core);
  }
  friend bool operator==(const Blobs&, const Blobs&) = default;
};

}  // namespace vortree::vortex
