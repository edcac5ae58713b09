#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "base/keys.hpp"
#include "flow/case.hpp"
#include "sph/neighbors/settings.hpp"
#include "sph/operators/stencils.hpp"

// The table of a scene that belongs to SPH.

namespace vortree::sph {

/// What is beyond the box: unbounded fluid, whose velocity at the box follows from the vorticity
/// (boundary/biot_savart.hpp); the stream as it is, as in a wide channel without friction; or the
/// same flow again, opposite sides being one.
enum class Outside { free, box, periodic };

}  // namespace vortree::sph

namespace vortree {

template <>
inline constexpr std::array<std::string_view, 3> words_of<sph::Outside>{"free", "box", "periodic"};

}  // namespace vortree

namespace vortree::sph {

/// An ellipse in which particles are at most `spacing` wide; half_axes the one that is turned by
/// `angle` from x, anticlockwise, and the other. In degrees.
struct RegionSettings {
  std::array<double, 2> centre{0, 0}, half_axes{0, 0};
  double angle = 0, spacing = 0;
  bool operator==(const RegionSettings&) const = default;
};

[[nodiscard]] std::vector<Key> keys(RegionSettings&);

/// spacing of particles at the body; `levels` of them, each twice as wide as the one before
/// (adapt/wanted_spacing.hpp); operators as in operators/stencils.hpp, the reach chosen by the
/// degree; a step takes the finest particle at most `courant` spacings along.
struct SphSettings {
  double spacing = 0;
  int levels = 0;
  double zone = 0;
  double growth = 2;
  std::vector<RegionSettings> regions{};
  std::optional<double> vorticity{};
  std::optional<std::array<double, 4>> box{};
  Outside outside = Outside::free;
  OperatorKind operators = OperatorKind::least_squares;
  int degree = 2;
  double reach = 0;
  int rings = 4;
  double shift = 6;
  double courant = 0.3;
  double tolerance = 1e-5;
  bool operator==(const SphSettings&) const = default;
};

[[nodiscard]] std::vector<Key> keys(SphSettings&);

/// The widest spacing, and the finest that is written.
[[nodiscard]] double coarsest_of(const SphSettings&);
[[nodiscard]] double finest_of(const SphSettings&);

/// A scene as the method sees it.
struct SphCase : flow::Case {
  SphSettings sph;
  NeighborSettings neighbors{};
};

}  // namespace vortree::sph
