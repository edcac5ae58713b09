#include "body/outlines/grading.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "body/outlines/panel_limits.hpp"
#include "body/outlines/touching_discs.hpp"
#include "body/shapes/circle.hpp"
#include "body/shapes/ellipse.hpp"
#include "body/shapes/naca0012.hpp"
#include "body/shapes/plate.hpp"

using namespace vortree;
using body::Grading;
using body::PanelLimits;

namespace {

std::vector<std::unique_ptr<body::Shape>> thin_shapes() {
  std::vector<std::unique_ptr<body::Shape>> shapes;
  shapes.push_back(body::ellipse({0.1, 0.2}, 0.5, 0.01, 0.5));
  shapes.push_back(body::naca0012({}, 1, 0.002, 0.1));
  shapes.push_back(body::plate({}, 1, 0.01, 0));
  return shapes;
}

}  // namespace

TEST_CASE("discs that touch a circle have its radius; an ellipse, b/a of its speed along t") {
  const auto circle = body::circle({1, 2}, 0.3);
  for (const double radius : touching_discs(*circle, circle->trace()))
    CHECK(radius == Approx(0.3).epsilon(1e-9));
  const double a = 0.5, b = 0.02;
  const auto ellipse = body::ellipse({}, a, b, 0);
  const auto trace = ellipse->trace();
  const auto radii = touching_discs(*ellipse, trace);
  for (std::size_t i = 0; i < trace.size(); ++i) {
    const double c = trace[i].at.x / a, s = trace[i].at.y / b;
    CHECK(radii[i] == Approx(b / a * std::hypot(a * s, b * c)).epsilon(1e-9));
  }
}

TEST_CASE("the discs of a plate are half as thick as it is along its sides") {
  const auto plate = body::plate({}, 1, 0.03, 0);
  const auto trace = plate->trace();
  const auto radii = touching_discs(*plate, trace);
  for (std::size_t i = 0; i < trace.size(); ++i)
    if (std::abs(trace[i].at.x) < 0.4) CHECK(radii[i] == Approx(0.015).epsilon(0.1));
}

TEST_CASE("panels on a circle, and where nothing is sharp or thin, are even to the bit") {
  const auto circle = body::circle({0.3, 0}, 0.5), blunt = body::ellipse({}, 0.5, 0.25, 0.3);
  for (const auto* shape : {circle.get(), blunt.get()})
    for (const int panels : {130, 520}) {
      const Grading grading(*shape, panels);
      const double length = shape->perimeter() / panels;
      CHECK(grading.even());
      for (const double t : {0.0, 0.5, 17.3, 99.0}) CHECK(grading.arc(t) == t * length);
      CHECK(grading.length(3.5) == length);
    }
  CHECK(Grading(*circle, 8).even());
}

TEST_CASE("graded panels go once around, none a third longer than its neighbor") {
  for (const auto& shape : thin_shapes())
    for (const int panels : {350, 501, 650}) {
      const Grading grading(*shape, panels);
      CHECK(!grading.even());
      CHECK(std::abs(grading.arc(0)) < 1e-15);
      CHECK(grading.arc(panels) == Approx(shape->perimeter()).epsilon(1e-12));
      double sum = 0;
      for (int i = 0; i < panels; ++i) {
        const double length = grading.length(i + 0.5), next = grading.length(i + 1.5);
        sum += length;
        CHECK(std::max(length, next) < 1.34 * std::min(length, next));
        CHECK(grading.arc(i + 0.5 + 1e-4) - grading.arc(i + 0.5 - 1e-4) ==
              Approx(2e-4 * length).epsilon(1e-6));
      }
      CHECK(sum == Approx(shape->perimeter()).epsilon(1e-8));  // the sum rule's 2 exp(-2 pi^2)
    }
}

TEST_CASE("as many as are needed keep to the limits of curvature and thickness") {
  for (const auto& shape : thin_shapes()) {
    const int panels = static_cast<int>(std::ceil(PanelLimits(*shape).needed()));
    const Grading grading(*shape, panels);
    const auto trace = shape->trace();
    const auto radii = touching_discs(*shape, trace);
    for (int k = 0; k < panels; ++k) {
      const double arc = grading.arc(k + 0.5);
      std::size_t i = 0;
      for (std::size_t j = 0; j < trace.size(); ++j)
        if (std::abs(trace[j].arc - arc) < std::abs(trace[i].arc - arc)) i = j;
      const double limit = std::min(0.7 / std::abs(trace[i].curvature), 1.25 * radii[i]);
      CHECK(grading.length(k + 0.5) < 1.5 * limit);  // a third by smoothing, and the place beside
    }
  }
}

TEST_CASE("the number of panels and the longest of them follow from each other") {
  for (const auto& shape : thin_shapes()) {
    const PanelLimits limits(*shape);
    for (const double more : {1.1, 1.5, 3.0, 20.0}) {
      const double panels = more * limits.needed(), longest = limits.longest_of(panels);
      CHECK(limits.panels_with(longest) == Approx(panels).epsilon(1e-6));
      CHECK(longest > 0.999 * shape->perimeter() / panels);
    }
    CHECK(limits.panels_with(10) == Approx(limits.needed()).epsilon(1e-12));
    CHECK(limits.longest_of(limits.needed() / 2) ==
          Approx(2 * limits.longest_of(limits.needed())).epsilon(1e-12));
  }
  const auto circle = body::circle({}, 0.5);
  CHECK(PanelLimits(*circle).panels_with(0.01) == circle->perimeter() / 0.01);
  CHECK(PanelLimits(*circle).longest_of(100) == circle->perimeter() / 100);
}
