#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "fmm/sources.hpp"
#include "point_sets.hpp"

namespace vortree::test {

/// Blobs whose velocities cancel.
struct Cancelling {
  std::string name;
  std::vector<double> x, y, gamma, sigma;

  void add(double px, double py, double strength, double core = 0.0) {
    x.push_back(px), y.push_back(py), gamma.push_back(strength), sigma.push_back(core);
  }
  [[nodiscard]] fmm::Sources blobs() const { return {x, y, gamma, sigma}; }
};

/// Groups of n on a small ring, signs alternating: dipoles, quadrupoles, octupoles.
inline void add_groups(Cancelling& set, int groups, int n, double width, double core,
                       double from = 0.0, double size = 1.0) {
  Uniform uniform(static_cast<std::uint64_t>(groups + n));
  for (int k = 0; k < groups; ++k) {
    const double a = from + size * uniform(), b = from + size * uniform();
    const double strength = 2 * uniform() - 1, turn = uniform();
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n + turn;
      set.add(a + width / 2 * std::cos(angle), b + width / 2 * std::sin(angle),
              i % 2 == 0 ? strength : -strength, core);
    }
  }
}

/// n x n signs by a rule on a lattice, places by another.
template <class Place, class Sign>
void add_board(Cancelling& set, int n, double core, Place place, Sign sign) {
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const auto [x, y] = place(i, j);
      set.add(x, y, sign(i, j), core);
    }
  }
}

inline std::vector<Cancelling> cancelling_sets() {
  using std::pair, std::numbers::pi;
  std::vector<Cancelling> sets;
  const auto make = [&](const std::string& name) -> Cancelling& {
    return sets.emplace_back(Cancelling{name, {}, {}, {}, {}});
  };
  for (const double width : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10}) {
    add_groups(make("cored dipoles"), 300, 2, width, 0.01);
  }
  for (const double width : {1e-2, 1e-5, 1e-8}) {
    add_groups(make("bare dipoles"), 300, 2, width, 0.0);
  }
  for (const double width : {1e-2, 1e-4}) {
    add_groups(make("cored quadrupoles"), 200, 4, width, 0.02);
    add_groups(make("bare quadrupoles"), 200, 4, width, 0.0);
    add_groups(make("bare octupoles"), 100, 8, width, 0.0);
  }

  const auto flat = [](int i, int j) { return pair(1.0 * i, 1.0 * j); };
  const auto turned = [](int i, int j) { return pair(0.8 * i - 0.6 * j, 0.6 * i + 0.8 * j); };
  const auto graded = [](int i, int j) { return pair(std::pow(1.15, i), std::pow(1.15, j)); };
  const auto chess = [](int i, int j) { return (i + j) % 2 == 0 ? 1.0 : -1.0; };
  const auto blocks = [](int i, int j) { return (i / 2 + j / 2) % 2 == 0 ? 1.0 : -1.0; };
  const auto stripes = [](int i, int) { return i % 2 == 0 ? 1.0 : -1.0; };
  for (const double core : {0.0, 0.5, 1.0, 2.0}) {
    add_board(make("checkerboard"), 32, core, flat, chess);
    add_board(make("checkerboard, turned"), 27, core, turned, chess);
  }
  add_board(make("checkerboard, graded"), 30, 0.0, graded, chess);
  add_board(make("checkerboard of blocks"), 32, 0.0, flat, blocks);
  add_board(make("stripes"), 32, 0.0, flat, stripes);

  auto& ring = make("ring");
  auto& line = make("line");
  for (int k = 0; k < 1000; ++k) {
    ring.add(std::cos(pi * k / 500), std::sin(pi * k / 500), k % 2 == 0 ? 1 : -1);
    line.add(k, 0.3 * k, k % 2 == 0 ? 1 : -1);
  }
  auto& sheets = make("two sheets");
  auto& cored_sheets = make("two sheets with cores");
  for (int k = 0; k < 400; ++k) {
    for (const int side : {1, -1}) {
      sheets.add(k / 400.0, side * 1e-4, side);
      cored_sheets.add(k / 400.0, side * 1e-6, side, 0.02);
    }
  }
  auto& nested = make("groups of no net circulation, from 1e-1 to 1e-6 wide");
  for (int scale = 1; scale <= 6; ++scale) {
    add_groups(nested, 20, 8, std::pow(10.0, -scale), 0.0);
  }
  Uniform uniform(5);
  for (const double others : {1.0, 1e-3, 1e-7}) {  // the dipoles rule only where others are weak
    auto& local = make("dipoles in a corner of a cloud");
    for (int k = 0; k < 400; ++k) {
      local.add(uniform(), uniform(), others * (2 * uniform() - 1), 0.02);
    }
    add_groups(local, 150, 2, 1e-7, 0.01, 0.5, 0.05);
  }
  auto& neutral = make("a wide core over narrow ones of the other sign");
  for (int k = 0; k < 800; ++k) neutral.add(uniform(), uniform(), 1.0, 0.05);
  neutral.add(0.5, 0.5, -800, 0.5);
  return sets;
}

}  // namespace vortree::test
