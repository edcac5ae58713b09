#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "fmm/geometry/deep_tree.hpp"
#include "point_sets.hpp"
#include "tree/build/build_reverse.hpp"
#include "tree/build/split_rule.hpp"

namespace vortree::test {

/// Points alone.
struct Places {
  std::vector<double> x, y;
  void add(double px, double py) { x.push_back(px), y.push_back(py); }
};

inline constexpr int place_kinds = 6;

/// Even, uneven, and narrower than a key can tell: clusters of 1e-11 and of 1e-13 of the whole, at
/// the origin and away from it, and points in one place.
inline Places make_places(int kind, std::size_t n, Uniform& uniform) {
  Places places;
  if (kind < 3) {
    const PointSet set = make_points(every_kind[kind], n);
    return {set.x, set.y};
  }
  const double size = kind == 3 ? 1e-11 : 1e-13;
  const double at_x = kind == 4 ? 0.0 : 0.7, at_y = kind == 4 ? 0.0 : -0.3;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = uniform(), y = uniform();
    if (i % 3 == 0) {
      places.add(x, y);
    } else if (kind == 5 && i % 3 == 1) {
      places.add(at_x, at_y);
    } else {
      places.add(at_x + size * x, at_y + size * y);
    }
  }
  return places;
}

/// A deep tree over places, as Full grows it.
struct Grown {
  Places places;
  fmm::Units units;
  tree::Quadtree base;
  fmm::DeepTree tree;

  Grown(Places some, std::uint32_t capacity, int finest = tree::max_level, bool deepen = true)
      : places(std::move(some)),
        units(fmm::Units::of({places.x, places.y, {}, {}})),
        base(tree::build_reverse(
            tree::morton_order({places.x, places.y}, tree::enclose({places.x, places.y}), finest),
            tree::crowded(capacity))),
        tree(base,
             fmm::side_by_side({places.x, places.y, std::vector(places.x.size(), 0.0), {}}, units),
             units, capacity, deepen) {}
};

/// Numbers of twice the digits.
using Quad = __float128;

inline Quad centre_x(const fmm::CellFrame& at) {
  return static_cast<Quad>(at.x) + at.x_rest;
}
inline Quad centre_y(const fmm::CellFrame& at) {
  return static_cast<Quad>(at.y) + at.y_rest;
}
inline double magnitude(Quad value) {
  return static_cast<double>(value < 0 ? -value : value);
}

}  // namespace vortree::test
