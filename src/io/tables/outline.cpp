#include "io/tables/outline.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "body/extent.hpp"
#include "body/shapes/shapes.hpp"
#include "io/files.hpp"

namespace vortree::io {

void write_outline(const std::filesystem::path& path, const body::BodySettings& body) {
  std::vector<body::OutlinePoint> closed = outline_of(body)->trace();
  closed.push_back(closed.front());
  std::string text = fmt::format("# D = {}\nx,y\n", length_of(body));
  for (const body::OutlinePoint& one : closed) text += fmt::format("{},{}\n", one.at.x, one.at.y);
  write_derived_text(path, text);
}

}  // namespace vortree::io
