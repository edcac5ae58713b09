#include "io/tables/coordinates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "io/input_error.hpp"
#include "io/sandbox.hpp"

using namespace vortree;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

struct Point {
  double x, y;
};

/// One side of a section, from the nose to the edge.
std::vector<Point> side_of(double way) {
  std::vector<Point> all;
  for (const double x : {0.0, 0.01, 0.04, 0.1, 0.3, 0.6, 0.8, 0.95, 1.0})
    all.push_back({x, way * (0.2 * std::sqrt(x) * (1 - x) + 0.002 * x)});
  return all;
}

std::string lines_of(const std::vector<Point>& all, const char* parted = " ") {
  std::string text;
  for (const Point& p : all) text += fmt::format("  {:.6f}{}{:.6f}\n", p.x, parted, p.y);
  return text;
}

/// From the edge over one side to the nose, and back on the other.
std::vector<Point> around() {
  std::vector<Point> all = side_of(1), other = side_of(-1);
  std::reverse(all.begin(), all.end());
  all.insert(all.end(), other.begin() + 1, other.end());
  return all;
}

std::string refusal_of(const Sandbox& box, const std::string& text) {
  const auto file = box.write("foil.dat", text);
  try {
    (void)io::read_coordinates(file);
  } catch (const io::InputError& error) {
    const std::string words = error.what(), place = file.string();
    CHECK_THAT(words, StartsWith(place));
    return words.substr(place.size());
  }
  return "";
}

}  // namespace

TEST_CASE("an outline is the same in two columns and in the layouts of Selig and Lednicer") {
  const Sandbox box;
  const auto read = [&](const std::string& text) {
    return io::read_coordinates(box.write("foil.dat", text));
  };
  const auto plain = read(lines_of(around()));
  REQUIRE(plain.size() == 2 * 17);
  CHECK((plain[0] == 1 && plain[1] == 0.002 && plain[16] == 0 && plain[32] == 1));
  CHECK(read("NACA 2412\n" + lines_of(around())) == plain);
  CHECK(read("NACA 2412, 17 points\r\n# drawn by hand\n\n" + lines_of(around(), ",\t")) == plain);
  CHECK(read("A FOIL\n   9.   9.\n\n" + lines_of(side_of(1)) + "\n" + lines_of(side_of(-1))) ==
        plain);
}

TEST_CASE("a file that is no outline is refused with the line that is to blame") {
  const Sandbox box;
  const std::string good = lines_of(around());
  CHECK(refusal_of(box, good).empty());
  CHECK(refusal_of(box, "NACA 2412\n") ==
        ":1: there are no points; lines of x and y were expected");
  CHECK(refusal_of(box, "") == ":1: there are no points; lines of x and y were expected");
  CHECK(refusal_of(box, "NACA 2412\n" + good + "and so on\n") ==
        ":19: \"and so on\": two numbers, x and y, were expected");
  CHECK(refusal_of(box, "NACA 2412\n" + good + "1 2 3\n") ==
        ":19: \"1 2 3\": two numbers, x and y, were expected");
  CHECK(refusal_of(box, "NACA 2412\n1.0 nan\n" + good) ==
        ":2: the point is (1, nan); finite numbers were expected");
  CHECK(refusal_of(box, good + "1 -0.002\n") ==
        ":18: the point (1, -0.002) is the same as the one before");
  CHECK(refusal_of(box, "A\n0 0\n1 0\n1 1\n") ==
        ":2: there are 3 points; an outline has 8 at least");
  CHECK(refusal_of(box, "A\n8. 9.\n" + lines_of(side_of(1)) + lines_of(side_of(-1))) ==
        ":2: its two sides are said to have 8 and 9 points; there are 18 in all");
  // The lower side above the upper one, from 0.6 on.
  std::vector<Point> crossed = around();
  for (std::size_t i = 13; i < 16; ++i) crossed[i].y = 0.2;
  CHECK_THAT(refusal_of(box, "A\n\n" + lines_of(crossed)),
             StartsWith(":") && Contains("the outline crosses itself: its sides at"));
  std::vector<Point> open = around();
  open.resize(11);
  CHECK_THAT(refusal_of(box, lines_of(open)), StartsWith(":") && Contains("the outline is open"));
}

TEST_CASE("the points of cases/naca2412.dat are those of the formula of NACA 2412") {
  const auto all = io::read_coordinates(VORTREE_SOURCE_DIR "/cases/naca2412.dat");
  REQUIRE(all.size() == 2 * 121);
  const int n = 60;
  for (int i = 0; i <= 2 * n; ++i) {
    const double x = 0.5 * (1 + std::cos(3.14159265358979 * i / n)), side = i <= n ? 1 : -1;
    const double half = 0.6 * (0.2969 * std::sqrt(x) - 0.1260 * x - 0.3516 * x * x +
                               0.2843 * std::pow(x, 3) - 0.1015 * std::pow(x, 4));
    const double steep = x < 0.4 ? 0.02 / 0.16 : 0.02 / 0.36, start = x < 0.4 ? 0 : 0.2;
    const double mean = steep * (start + 0.8 * x - x * x), theta = std::atan(2 * steep * (0.4 - x));
    CHECK(all[2 * i] == Approx(x - side * half * std::sin(theta)).margin(6e-8));
    CHECK(all[2 * i + 1] == Approx(mean + side * half * std::cos(theta)).margin(6e-8));
  }
}
