#pragma once

#include <array>
#include <optional>
#include <span>

#include "body/shape.hpp"

namespace vortree::body {

/// The numbers of the first two sides of a closed polygon that meet elsewhere than where one
/// follows upon the other; side i leads from place i to the next.
/// cost  1 ms for 500 sides
[[nodiscard]] std::optional<std::array<std::size_t, 2>> crossing_of(std::span<const Vec2> polygon);

/// An outline that crosses itself, or turns by more than 1 rad between two places of its trace.
[[nodiscard]] bool folds(const Shape& shape);

}  // namespace vortree::body
