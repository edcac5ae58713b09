#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/kinds.hpp"
#include "body/settings.hpp"
#include "body/shape.hpp"

// The shapes of bodies that a scene can name. Each is a file of this room, which has its numbers,
// its length and its curve, and a word in the list of shapes.cpp. What else is asked of a shape
// follows from its outline (body/extent.hpp).

namespace vortree::body {

inline void no_objection(const BodySettings&) {}
inline std::vector<std::string> nothing_told(const BodySettings&) {
  return {};
}

/// length  the size D that coefficients and the Reynolds number go by [L]
/// draw    the outline about the origin, turned clockwise by the body's incidence
/// also    "digits" or "points", if it takes these beside numbers
/// hold    throws Refused for numbers each of which may be, but that make no outline together
/// told    what it makes of them that somebody may not expect, in sentences
///
/// Length, draw and told take what `refuse` lets pass.
struct ShapeKind : Kind {
  double (*length)(const BodySettings&);
  std::unique_ptr<Shape> (*draw)(const BodySettings&);
  std::string_view also{};
  void (*hold)(const BodySettings&) = no_objection;
  std::vector<std::string> (*told)(const BodySettings&) = nothing_told;
};

/// All of them; the first is that of a body whose scene names none.
[[nodiscard]] std::span<const ShapeKind* const> shape_kinds();

/// The outline of a body about the origin.
/// cost    0.2 to 0.5 ms
/// throws  std::invalid_argument if a number is lacking or out of its limits
[[nodiscard]] std::unique_ptr<Shape> outline_of(const BodySettings& body);

}  // namespace vortree::body
