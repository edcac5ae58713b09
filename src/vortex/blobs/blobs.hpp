#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec2.hpp"
#include "vortex/blobs/covariance.hpp"

namespace vortree::vortex {

/// Vortex blobs: the whole state of the vorticity field, copied, compared and saved as a value.
///
///   omega(x) = sum_j gamma_j / (pi sigma_j^2) exp(-|x - x_j|^2 / sigma_j^2)
///
/// x, y centres [m]; gamma circulation [m^2/s], anticlockwise positive; sigma core size [m].
/// xx, xy what a core's covariance has beyond sigma^2/2 I [m^2] (covariance.hpp): the strain that a
/// blob has been through. Its velocity and vorticity are those of a round core beside a wall, where
/// the children that it splits into are laid out by the strain, and those of two halves in free
/// space (cores/halves.hpp).
struct Blobs {
  std::vector<double> x, y, gamma, sigma, xx, xy;

  Blobs() = default;
  /// Round ones.
  Blobs(std::vector<double> at_x, std::vector<double> at_y, std::vector<double> circulation,
        std::vector<double> core)
      : x(std::move(at_x)),
        y(std::move(at_y)),
        gamma(std::move(circulation)),
        sigma(std::move(core)),
        xx(x.size()),
        xy(x.size()) {}

  std::size_t size() const { return x.size(); }
  Vec2 centre(std::size_t i) const { return {x[i], y[i]}; }
  Core core(std::size_t i) const { return {sigma[i] * sigma[i], {xx[i], xy[i]}}; }
  void reserve(std::size_t n) {
    for (auto* column : {&x, &y, &gamma, &sigma, &xx, &xy}) column->reserve(n);
  }
  void resize(std::size_t n) {
    for (auto* column : {&x, &y, &gamma, &sigma, &xx, &xy}) column->resize(n);
  }
  void put(std::size_t i, Vec2 at, double circulation, const Core& core) {
    x[i] = at.x;
    y[i] = at.y;
    gamma[i] = circulation;
    sigma[i] = std::sqrt(core.square);
    xx[i] = core.deviator.xx;
    xy[i] = core.deviator.xy;
  }
  void append(Vec2 at, double circulation, const Core& core) {
    resize(size() + 1);
    put(size() - 1, at, circulation, core);
  }
  /// A round one.
  void append(Vec2 at, double circulation, double core) {
    append(at, circulation, Core{core * core});
    sigma.back() = core;
  }
  /// Takes these away; the others keep their order.
  ///
  /// numbers  ascending
  void erase(std::span<const std::uint32_t> numbers) {
    if (numbers.empty()) return;
    for (auto* column : {&x, &y, &gamma, &sigma, &xx, &xy}) {
      std::size_t left = numbers.front();
      for (std::size_t k = 0; k < numbers.size(); ++k) {
        const std::size_t next = k + 1 < numbers.size() ? numbers[k + 1] : column->size();
        left = std::copy(column->begin() + numbers[k] + 1, column->begin() + next,
                         column->begin() + left) -
               column->begin();
      }
      column->resize(left);
    }
  }
  friend bool operator==(const Blobs&, const Blobs&) = default;
};

}  // namespace vortree::vortex
