#include "io/xdmf.hpp"

#include <fmt/format.h>

namespace vortree::io {
namespace {

constexpr std::string_view ending = "</Grid>\n</Domain>\n</Xdmf>\n";

std::string column(std::string_view file, const FrameLabel& frame, std::string_view name) {
  return fmt::format(
      "<DataItem Dimensions=\"{}\" NumberType=\"Float\" Precision=\"8\" Format=\"HDF\">"
      "{}:/{}/{}</DataItem>\n",
      frame.blobs, file, frame_name(frame.step), name);
}

std::string scalar(std::string_view file, const FrameLabel& frame, std::string_view name) {
  return fmt::format(
      "<Attribute Name=\"{}\" AttributeType=\"Scalar\" Center=\"Node\">\n{}"
      "</Attribute>\n",
      name, column(file, frame, name));
}

std::string velocity(std::string_view file, const FrameLabel& frame) {
  return fmt::format(
      "<Attribute Name=\"velocity\" AttributeType=\"Vector\" Center=\"Node\">\n"
      "<DataItem ItemType=\"Function\" Function=\"JOIN($0, $1, 0*$0)\" Dimensions=\"{} 3\">\n"
      "{}{}</DataItem>\n</Attribute>\n",
      frame.blobs, column(file, frame, "u"), column(file, frame, "v"));
}

std::string grid(std::string_view file, const FrameLabel& frame) {
  std::string text = fmt::format(
      "<Grid Name=\"{}\" GridType=\"Uniform\">\n<Time Value=\"{}\"/>\n"
      "<Topology TopologyType=\"Polyvertex\" NumberOfElements=\"{}\" NodesPerElement=\"1\"/>\n"
      "<Geometry GeometryType=\"X_Y\">\n{}{}</Geometry>\n",
      frame_name(frame.step), frame.time, frame.blobs, column(file, frame, "x"),
      column(file, frame, "y"));
  for (const char* name : {"gamma", "sigma", "u", "v"}) text += scalar(file, frame, name);
  return text + velocity(file, frame) + "</Grid>\n";
}

}  // namespace

bool add_to_xdmf(std::string& page, std::string_view file, const FrameLabel& frame) {
  if (!page.ends_with(ending)) return false;
  page.resize(page.size() - ending.size());
  if (frame.blobs > 0) page += grid(file, frame);
  page += ending;
  return true;
}

std::string xdmf_text(std::string_view file, std::span<const FrameLabel> frames) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\">\n<Domain>\n"
      "<Grid Name=\"frames\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  for (const FrameLabel& frame : frames) {
    if (frame.blobs > 0) text += grid(file, frame);
  }
  return text.append(ending);
}

}  // namespace vortree::io
