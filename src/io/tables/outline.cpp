#include "io/tables/outline.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "body/extent.hpp"
#include "body/shapes/shapes.hpp"
#include "io/files.hpp"

namespace vortree::io {

namespace {

/// Of one that stands at `at`, as seen from the first.
std::string rows(const body::BodySettings& body, const Pair& at, const std::string& number) {
  std::vector<body::OutlinePoint> closed = outline_of(body)->trace();
  closed.push_back(closed.front());
  std::string text;
  for (const body::OutlinePoint& one : closed)
    text += fmt::format("{},{}{}\n", at[0] + one.at.x, at[1] + one.at.y, number);
  return text;
}

}  // namespace

void write_outlines(const std::filesystem::path& path, const flow::BodyList& bodies) {
  const bool several = bodies.size() > 1;
  const Pair& first = bodies.front().get().centre;
  std::string text =
      fmt::format("# D = {}\nx,y{}\n", length_of(bodies.front()), several ? ",body" : "");
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const Pair& centre = bodies[k].get().centre;
    text += rows(bodies[k], {centre[0] - first[0], centre[1] - first[1]},
                 several ? fmt::format(",{}", k + 1) : "");
  }
  write_derived_text(path, text);
}

}  // namespace vortree::io
