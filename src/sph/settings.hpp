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
/// (boundary/biot_savart.hpp), or the stream as it is, as in a wide channel without friction.
enum class Outside { free, box };

}  // namespace vortree::sph

namespace vortree {

template <>
inline constexpr std::array<std::string_view, 2> words_of<sph::Outside>{"free", "box"};

}  // namespace vortree

namespace vortree::sph {

/// spacing of particles at the body; `levels` of them, each twice as wide as the one before
/// (adapt/wanted_spacing.hpp); operators as in operators/stencils.hpp, the reach chosen by the
/// degree; a step takes the finest particle at most `courant` spacings along.
struct SphSettings {
  double spacing = 0;
  int levels = 0;
  double zone = 0;
  double growth = 2;
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

/// A scene as the method sees it.
struct SphCase : flow::Case {
  SphSettings sph;
  NeighborSettings neighbors{};
};

}  // namespace vortree::sph
