#include "io/frames/xdmf.hpp"

#include <fmt/format.h>

namespace vortree::io {
namespace {

constexpr std::string_view ending = "</Grid>\n</Domain>\n</Xdmf>\n";

std::string opening(std::string_view name) {
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n"
      "<Grid Name=\"{}\" GridType=\"Collection\" CollectionType=\"Temporal\">\n",
      name);
}

/// A dataset of the HDF5 file: `path` is its file and group.
std::string item(std::string_view path, std::string_view name, std::string_view dimensions,
                 std::string_view type = "NumberType=\"Float\" Precision=\"8\"") {
  return fmt::format("<DataItem Dimensions=\"{}\" {} Format=\"HDF\">{}/{}</DataItem>\n", dimensions,
                     type, path, name);
}

std::string attribute(std::string_view name, std::string_view kind, std::string_view values) {
  return fmt::format(
      "<Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"Node\">\n{}</Attribute>\n", name, kind,
      values);
}

std::string grid(std::string_view file, const FrameLabel& frame) {
  const std::string path = fmt::format("{}:/{}", file, frame_name(frame.step));
  const std::string n = fmt::format("{}", frame.particles), n3 = n + " 3", n1 = n + " 1";
  std::string text = fmt::format(
      "<Grid Name=\"{}\" GridType=\"Uniform\">\n<Time Value=\"{}\"/>\n"
      "<Topology TopologyType=\"Polyvertex\" NumberOfElements=\"{}\" NodesPerElement=\"1\">\n{}"
      "</Topology>\n<Geometry GeometryType=\"XYZ\">\n{}</Geometry>\n",
      frame_name(frame.step), frame.time, n,
      item(path, "view/vertices", n1, "NumberType=\"Int\" Precision=\"4\""),
      item(path, "view/points", n3));
  for (const std::string& name : frame.columns)
    if (name != "x" && name != "y") text += attribute(name, "Scalar", item(path, name, n));
  if (frame.has("u") && frame.has("v"))
    text += attribute("velocity", "Vector", item(path, "view/velocity", n3));
  return text + "</Grid>\n";
}

std::string grid(std::string_view file, const FieldLabel& field) {
  const std::string path = fmt::format("{}:/{}", file, field.name);
  const std::string shape = fmt::format("{} {}", field.rows, field.columns);
  std::string text = fmt::format(
      "<Grid Name=\"{}\" GridType=\"Uniform\">\n<Time Value=\"{}\"/>\n"
      "<Topology TopologyType=\"2DRectMesh\" Dimensions=\"{}\"/>\n"
      "<Geometry GeometryType=\"VXVY\">\n{}{}</Geometry>\n",
      field.name, field.time, shape, item(path, "x", fmt::format("{}", field.columns)),
      item(path, "y", fmt::format("{}", field.rows)));
  for (const std::string& name : field.values)
    text += attribute(name, "Scalar", item(path, name, shape));
  return text + "</Grid>\n";
}

}  // namespace

bool add_to_xdmf(std::string& page, std::string_view file, const FrameLabel& frame) {
  if (!page.ends_with(ending)) return false;
  page.resize(page.size() - ending.size());
  if (frame.particles > 0) page += grid(file, frame);
  page += ending;
  return true;
}

std::string xdmf_text(std::string_view file, std::span<const FrameLabel> frames) {
  std::string text = opening("frames");
  for (const FrameLabel& frame : frames) {
    if (frame.particles > 0) text += grid(file, frame);
  }
  return text.append(ending);
}

std::string fields_xdmf_text(std::string_view file, std::span<const FieldLabel> fields) {
  std::string text = opening("fields");
  for (const FieldLabel& field : fields) text += grid(file, field);
  return text.append(ending);
}

}  // namespace vortree::io
