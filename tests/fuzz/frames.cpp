#include "io/frames/frames.hpp"

#include "input.hpp"
#include "io/frames/read.hpp"
#include "io/tables/fields.hpp"

using namespace vortree;

// A file as the frames and as the fields of a run that goes on: read, then rewound to its last
// frame.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::Folder folder;
  const auto frames = folder.with("frames.h5", data, size);
  (void)folder.with("fields.h5", data, size);
  fuzz::expect_answer([&] { (void)io::read_frames(frames, 2); });
  fuzz::expect_answer([&] {
    for (const double time : io::field_times(folder.path())) {
      fuzz::expect_answer([&] { (void)io::read_field(folder.path(), time); });
    }
    (void)io::rewind_fields(folder.path(), 1);
  });
  fuzz::expect_answer([&] {
    const io::RecoveredFrames found = io::read_last_good(frames);
    if (!found.last) return;
    io::rewind_frames(folder.path(), found.last->step);
    const io::RecoveredFrames again = io::read_last_good(frames);
    if (!again.last || again.last->step != found.last->step || !again.warning.empty()) {
      fuzz::fail("a file that was mended is not whole: " + again.warning);
    }
  });
  return 0;
}
