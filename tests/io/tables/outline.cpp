#include "io/tables/outline.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>

#include "body/shapes/naca0012.hpp"
#include "body/some_bodies.hpp"
#include "io/sandbox.hpp"
#include "io/tables/table.hpp"

using namespace vortree;

TEST_CASE("the outline of a body is a closed table, from its centre, below a note of its length") {
  const Sandbox box;
  body::BodySettings foil{.shape = &test::shape_kind("naca0012"),
                          .numbers = {{"chord", 2}, {"edge", 0.01}},
                          .incidence = 30,
                          .centre = {7, 9}};
  io::write_outlines(box / "outline.csv", {foil});
  std::ifstream file(box / "outline.csv");
  std::string note;
  std::getline(file, note);
  CHECK(note == "# D = 2");
  const io::Table table(box / "outline.csv");
  CHECK(table.names() == std::vector<std::string>{"x", "y"});
  const auto x = table.column("x"), y = table.column("y");
  REQUIRE(x.size() == 513);
  CHECK((x.front() == x.back() && y.front() == y.back()));
  const auto known = body::naca0012({}, 2, 0.01, foil.turn());
  double twice_area = 0, longest = 0;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    CHECK(std::abs(known->distance({x[i], y[i]})) < 1e-14);
    twice_area += x[i] * y[i + 1] - x[i + 1] * y[i];
    longest = std::max(longest, std::hypot(x[i + 1] - x[i], y[i + 1] - y[i]));
  }
  CHECK(longest < 0.01 * 2);
  // Anticlockwise; the section, with its edge as thick as that, has 0.085 of the chord's square.
  CHECK(twice_area / 2 / 4 == Approx(0.085).epsilon(0.05));
}
