#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/frames/frames.hpp"
#include "io/frames/hdf5.hpp"

// One frame as a group of an HDF5 file. Throws h5::Failure for whatever cannot be read or written.

namespace vortree::io {

/// frame_000025
[[nodiscard]] std::string frame_name(std::int64_t step);

/// Where a frame stands among the links of the root.
struct FramePlace {
  std::int64_t step;
  hsize_t index;
};

/// All links of the root that are named like frames, by ascending step; says nothing of what they
/// hold. Links are counted, not looked up by name, so that one damaged name hides no other.
[[nodiscard]] std::vector<FramePlace> frame_places(hid_t file);

/// Writes the frame complete, flushes it, and only then links it into the file.
void write_frame(hid_t file, const Frame&);

/// Reads a frame. throws h5::Failure if it is damaged: also when its checksum, or what is drawn of
/// it, does not agree.
[[nodiscard]] Frame read_frame(hid_t file, const FramePlace&);

/// Time, number of particles and names of the columns of a frame, without reading these.
struct FrameLabel {
  std::int64_t step;
  double time;
  std::uint64_t particles;
  std::vector<std::string> columns;

  bool has(std::string_view name) const;
};
[[nodiscard]] FrameLabel label_of(const Frame&);
[[nodiscard]] FrameLabel read_label(hid_t file, const FramePlace&);

}  // namespace vortree::io
