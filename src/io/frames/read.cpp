#include "io/frames/read.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/files.hpp"
#include "io/frames/group.hpp"
#include "io/frames/hdf5.hpp"

namespace vortree::io {

std::vector<Frame> read_frames(const std::filesystem::path& path, std::size_t most) {
  require_regular_file(path);
  try {
    const h5::Handle file = h5::open_file(path);
    const std::vector<FramePlace> places = frame_places(file);
    const std::size_t count = std::min(most, places.size());
    std::vector<Frame> frames;
    for (std::size_t k = 1; k <= count; ++k) {
      frames.push_back(read_frame(file, places[places.size() * k / count - 1]));
    }
    return frames;
  } catch (const h5::Failure& failure) {
    throw InputError(fmt::format("{}: {}", path.string(), failure.what()));
  }
}

Frame read_frame_of(const std::filesystem::path& path, std::optional<std::size_t> number) {
  require_regular_file(path);
  try {
    const h5::Handle file = h5::open_file(path);
    const std::vector<FramePlace> places = frame_places(file);
    if (places.empty()) throw h5::Failure("it has no frames of a run");
    const std::size_t wanted = number.value_or(places.size() - 1);
    if (wanted < places.size()) return read_frame(file, places[wanted]);
    throw h5::Failure(fmt::format("it has {} frames, 0 to {}; there is no frame {}", places.size(),
                                  places.size() - 1, wanted));
  } catch (const h5::Failure& failure) {
    throw InputError(fmt::format("{}: {}", path.string(), failure.what()));
  }
}

FramesLabel label_of_frames(const std::filesystem::path& path) {
  require_regular_file(path);
  try {
    const h5::Handle file = h5::open_file(path);
    const std::vector<FramePlace> places = frame_places(file);
    if (places.empty()) return {};
    return {.frames = places.size(), .last_time = read_label(file, places.back()).time};
  } catch (const h5::Failure& failure) {
    throw InputError(fmt::format("{}: {}", path.string(), failure.what()));
  }
}

}  // namespace vortree::io
