#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>

#include "body/shapes/circle.hpp"
#include "body/shapes/ellipse.hpp"
#include "body/shapes/naca0012.hpp"
#include "body/shapes/shapes.hpp"

namespace vortree::test {

/// The shape of that name.
inline const body::ShapeKind& shape_kind(std::string_view name) {
  const auto found = std::ranges::find(body::shape_kinds(), name, &Kind::name);
  if (found == body::shape_kinds().end()) throw std::out_of_range("no shape " + std::string(name));
  return **found;
}

inline body::BodySettings circle(double radius) {
  return {.shape = &shape_kind("circle"), .numbers = {{"radius", radius}}};
}

inline body::BodySettings ellipse(double radius, double across, double incidence = 0) {
  return {.shape = &shape_kind("ellipse"),
          .numbers = {{"radius", radius}, {"across", across}},
          .incidence = incidence};
}

inline body::BodySettings foil(double chord, double incidence = 0) {
  return {.shape = &shape_kind("naca0012"), .numbers = {{"chord", chord}}, .incidence = incidence};
}

}  // namespace vortree::test
