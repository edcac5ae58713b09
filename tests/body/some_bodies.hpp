#pragma once

#include "body/shapes/circle.hpp"
#include "body/shapes/ellipse.hpp"
#include "body/shapes/naca0012.hpp"
#include "body/shapes/shapes.hpp"

namespace vortree::test {

inline body::BodySettings circle(double radius) {
  return {.shape = &body::shape_kind("circle"), .numbers = {{"radius", radius}}};
}

inline body::BodySettings ellipse(double radius, double across, double incidence = 0) {
  return {.shape = &body::shape_kind("ellipse"),
          .numbers = {{"radius", radius}, {"across", across}},
          .incidence = incidence};
}

inline body::BodySettings foil(double chord, double incidence = 0) {
  return {.shape = &body::shape_kind("naca0012"),
          .numbers = {{"chord", chord}},
          .incidence = incidence};
}

}  // namespace vortree::test
