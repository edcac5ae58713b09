#include <sys/wait.h>
#include <unistd.h>

#include "frame_runs.hpp"
#include "io/frames/hdf5.hpp"

using namespace vortree::io;
using namespace vortree::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

TEST_CASE("a frame comes back bit for bit, with the run it belongs to") {
  const Sandbox box;
  write_run(box, 3, 100);
  const RecoveredFrames found = read_last_good(frames_in(box));
  CHECK(found.warning.empty());
  CHECK(found.info == info);
  CHECK(found.steps == std::vector<std::int64_t>{0, 25, 50});
  REQUIRE(found.last);
  CHECK(same(*found.last, frame_of(50, 120)));
}

TEST_CASE("a run with no frames yet, and frames with no blobs, are healthy") {
  const Sandbox box;
  create_frames(box / "new/run", info);
  const RecoveredFrames none = read_last_good(box / "new/run/frames.h5");
  CHECK(none.warning.empty());
  CHECK_FALSE(none.last);
  append_frame(box / "new/run", frame_of(0, 0));
  const RecoveredFrames empty = read_last_good(box / "new/run/frames.h5");
  CHECK(empty.warning.empty());
  REQUIRE(empty.last);
  CHECK(same(*empty.last, frame_of(0, 0)));
}

TEST_CASE("a rewound file goes on as if it had never been hurt") {
  const Sandbox box, twin;
  const auto ends = write_run(box, 5, 40);
  write_run(twin, 6, 40);
  SECTION("cut in the fourth frame") {
    std::filesystem::resize_file(frames_in(box), ends[3] - 100);
  }
  SECTION("healthy, but to be resumed from an earlier step") {}
  rewind_frames(box.path(), 50);
  const RecoveredFrames rewound = read_last_good(frames_in(box));
  CHECK(rewound.warning.empty());
  CHECK(rewound.info == info);
  CHECK(rewound.steps == std::vector<std::int64_t>{0, 25, 50});
  CHECK(same(*rewound.last, frame_of(50, 60)));
  for (std::int64_t k = 3; k < 6; ++k) append_frame(box.path(), frame_of(25 * k, 40 + 10 * k));
  CHECK(read_last_good(frames_in(box)).steps == read_last_good(frames_in(twin)).steps);
  CHECK(text_of(box / "frames.xdmf") == text_of(twin / "frames.xdmf"));
  CHECK(std::distance(std::filesystem::directory_iterator(box.path()), {}) == 2);
  SECTION("and survives another cut") {
    // Four bytes: a checksum of HDF5's, of which one alone may be the zero that takes its place.
    std::filesystem::resize_file(frames_in(box), std::filesystem::file_size(frames_in(box)) - 4);
    CHECK(read_last_good(frames_in(box)).last->step == 100);
  }
}

TEST_CASE("rewinding to a step that is not there changes nothing") {
  const Sandbox box;
  write_run(box, 2, 10);
  const std::string before = text_of(frames_in(box));
  CHECK_THROWS_AS(rewind_frames(box.path(), 30), std::invalid_argument);
  CHECK(text_of(frames_in(box)) == before);
  CHECK(std::distance(std::filesystem::directory_iterator(box.path()), {}) == 2);
}

TEST_CASE("a frame that contradicts itself or the file is refused") {
  const Sandbox box;
  write_run(box, 2, 10);
  CHECK_THROWS_AS(append_frame(box.path(), frame_of(25, 10)), std::invalid_argument);
  Frame uneven = frame_of(50, 10);
  uneven.columns[3].values.pop_back();
  CHECK_THROWS_AS(append_frame(box.path(), uneven), std::invalid_argument);
  CHECK(read_last_good(frames_in(box)).steps == std::vector<std::int64_t>{0, 25});
  CHECK_THROWS_WITH(append_frame(box / "none", frame_of(0, 1)),
                    Contains("the frame of step 0 cannot be saved"));
}

TEST_CASE("steps of more digits than the name foresees keep their order") {
  const Sandbox box;
  create_frames(box.path(), info);
  for (const std::int64_t step : {5, 999999, 1000000, 20000000}) {
    append_frame(box.path(), frame_of(step, 3));
  }
  CHECK(read_last_good(frames_in(box)).steps ==
        std::vector<std::int64_t>{5, 999999, 1000000, 20000000});
}

TEST_CASE("a folder that cannot be made is refused") {
  const Sandbox box;
  const auto file = box.write("file", "");
  CHECK_THAT(refusal([&] { create_frames(file / "run", info); }),
             StartsWith((file / "run/frames.h5").string() + " cannot be written in the folder "));
}

TEST_CASE("a reader that looks at the frames does not stop the run") {
  const Sandbox box;
  write_run(box, 1, 10);
  int to_reader[2], from_reader[2];
  REQUIRE(pipe(to_reader) == 0);
  REQUIRE(pipe(from_reader) == 0);
  const pid_t reader = fork();
  if (reader == 0) {
    // Opened as other programs open it: with HDF5's lock.
    const hid_t file = H5Fopen(frames_in(box).c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    char word = file >= 0 ? 'y' : 'n';
    if (write(from_reader[1], &word, 1) != 1 || read(to_reader[0], &word, 1) != 1) _exit(1);
    _exit(0);
  }
  char opened = 'n';
  REQUIRE(read(from_reader[0], &opened, 1) == 1);
  CHECK(opened == 'y');
  CHECK_NOTHROW(append_frame(box.path(), frame_of(25, 10)));
  CHECK(write(to_reader[1], "q", 1) == 1);
  CHECK(waitpid(reader, nullptr, 0) == reader);
  for (const int end : {to_reader[0], to_reader[1], from_reader[0], from_reader[1]}) close(end);
  CHECK(read_last_good(frames_in(box)).steps == std::vector<std::int64_t>{0, 25});
}

TEST_CASE("a file of one frame takes the place of an older one, and is read as any other") {
  const Sandbox box;
  write_frames(box / "state.h5", info, frame_of(25, 40));
  write_frames(box / "state.h5", info, frame_of(50, 30));
  const RecoveredFrames found = read_last_good(box / "state.h5");
  CHECK(found.warning.empty());
  CHECK(found.info == info);
  CHECK(found.steps == std::vector<std::int64_t>{50});
  REQUIRE(found.last);
  CHECK(same(*found.last, frame_of(50, 30)));
  CHECK(std::distance(std::filesystem::directory_iterator(box.path()), {}) == 1);
  Frame uneven = frame_of(50, 10);
  uneven.columns[3].values.pop_back();
  CHECK_THROWS_AS(write_frames(box / "state.h5", info, uneven), std::invalid_argument);
  CHECK_THROWS_AS(write_frames(box / "none/state.h5", info, frame_of(0, 1)), InputError);
  CHECK(read_last_good(box / "state.h5").steps == std::vector<std::int64_t>{50});
}
