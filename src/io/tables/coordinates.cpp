#include "io/tables/coordinates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>

#include "body/shapes/from_points/contour.hpp"
#include "io/files.hpp"
#include "io/input_error.hpp"
#include "io/quote.hpp"
#include "io/tables/table.hpp"

namespace vortree::io {
namespace {

struct NumberedLine {
  int number;
  std::string text;
};

struct PointOfLine {
  double x, y;
  int line;
};
using PointsOfLines = std::vector<PointOfLine>;

[[noreturn]] void refuse(const std::filesystem::path& file, int line, std::string_view words) {
  throw InputError(fmt::format("{}:{}: {}", file.string(), line, words));
}

/// But for notes.
std::vector<NumberedLine> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<NumberedLine> all;
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    std::ranges::replace_if(
        line, [](char c) { return c == ',' || c == '\t' || c == '\r'; }, ' ');
    const auto first = line.find_first_not_of(' ');
    if (first != std::string::npos && line[first] != '#') all.push_back({number, line});
  }
  return all;
}

/// Two numbers and no more; a name is none, though it may begin with them: "2412 foil".
std::optional<PointOfLine> point_of(const NumberedLine& line) {
  std::istringstream words(line.text);
  std::string x, y, more;
  if (!(words >> x >> y) || words >> more) return std::nullopt;
  const auto a = number(x), b = number(y);
  if (!a || !b) return std::nullopt;
  return PointOfLine{*a, *b, line.number};
}

PointsOfLines points_of(const std::filesystem::path& file, const std::vector<NumberedLine>& lines) {
  PointsOfLines all;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto point = point_of(lines[i]);
    if (!point && i == 0) continue;  // a name
    if (!point)
      refuse(file, lines[i].number,
             fmt::format("{}: two numbers, x and y, were expected",
                         quote(shortened(lines[i].text, 60))));
    if (!std::isfinite(point->x) || !std::isfinite(point->y))
      refuse(
          file, point->line,
          fmt::format("the point is ({}, {}); finite numbers were expected", point->x, point->y));
    all.push_back(*point);
  }
  return all;
}

/// The two counts of Lednicer's layout: whole numbers above 1, where an outline in chords has none.
bool counts(const PointOfLine& point) {
  return point.x > 1.5 && point.y > 1.5 && point.x == std::floor(point.x) &&
         point.y == std::floor(point.y);
}

/// The first side backwards, then the second without the nose, if that is there again.
PointsOfLines in_order(const std::filesystem::path& file, const PointsOfLines& all) {
  const PointOfLine& sides = all.front();
  if (sides.x + sides.y != static_cast<double>(all.size() - 1))
    refuse(file, sides.line,
           fmt::format("its two sides are said to have {} and {} points; there are {} in all",
                       sides.x, sides.y, all.size() - 1));
  const auto second = all.begin() + 1 + static_cast<std::ptrdiff_t>(sides.x);
  PointsOfLines points(all.begin() + 1, second);
  std::ranges::reverse(points);
  const bool again = second->x == points.back().x && second->y == points.back().y;
  points.insert(points.end(), second + (again ? 1 : 0), all.end());
  return points;
}

}  // namespace

std::vector<double> read_coordinates(const std::filesystem::path& file) {
  require_regular_file(file);
  const std::vector<NumberedLine> lines = lines_of(read_text(file));
  PointsOfLines points = points_of(file, lines);
  if (points.empty())
    refuse(file, lines.empty() ? 1 : lines.front().number,
           "there are no points; lines of x and y were expected");
  const bool named = points.front().line != lines.front().number;
  if (named && counts(points.front())) points = in_order(file, points);
  std::vector<double> coordinates;
  for (const PointOfLine& point : points) {
    coordinates.push_back(point.x);
    coordinates.push_back(point.y);
  }
  try {
    body::hold_points(coordinates);
  } catch (const body::BadPoint& bad) {
    refuse(file, points[std::min(bad.point, points.size() - 1)].line, bad.what());
  }
  return coordinates;
}

}  // namespace vortree::io
