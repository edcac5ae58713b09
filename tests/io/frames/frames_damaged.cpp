#include <sys/ptrace.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "frame_runs.hpp"
#include "io/frames/hdf5.hpp"

using namespace vortree::io;
using namespace vortree::test;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

TEST_CASE("cut anywhere, a frames file gives its last whole frame, or says that none is left") {
  const Sandbox box;
  const std::vector<std::uintmax_t> ends = write_run(box, 6, 40);
  const std::string whole = text_of(frames_in(box));
  REQUIRE(whole.size() == ends.back());
  std::mt19937 random(550);
  std::uniform_int_distribution<std::uintmax_t> any(0, whole.size() - 1);
  std::vector<std::uintmax_t> lengths{0, 1, 7, 8, 9, 47, 48, 96, 1000};
  for (const std::uintmax_t end : ends) lengths.insert(lengths.end(), {end - 1, end});
  while (lengths.size() < 200) lengths.push_back(any(random));
  // Uniform lengths mostly hit the table of names at the beginning: as many behind it.
  std::uniform_int_distribution<std::uintmax_t> behind(ends[0], whole.size() - 1);
  while (lengths.size() < 400) lengths.push_back(behind(random));
  for (const std::uintmax_t length : lengths) {
    CAPTURE(length, whole.size());
    const auto cut = box.write("cut.h5", whole.substr(0, length));
    const RecoveredFrames found = read_last_good(cut);
    const auto inside = std::upper_bound(ends.begin(), ends.end(), length) - ends.begin();
    REQUIRE(found.steps.size() == static_cast<std::size_t>(inside));
    REQUIRE(found.last.has_value() == (inside > 0));
    CHECK(found.warning.empty() == (length == whole.size()));
    if (inside > 0) {
      const Frame last = frame_of(25 * (inside - 1), 40 + 10 * (inside - 1));
      CHECK(same(*found.last, last));
      CHECK(found.info == info);
    } else {
      CHECK_THAT(found.warning, StartsWith(cut.string() + " is cut short at byte ") &&
                                    EndsWith("no good frame is left in it"));
    }
  }
  CHECK(std::distance(std::filesystem::directory_iterator(box.path()), {}) == 3);
}

TEST_CASE("the warning says what is lost and what is left") {
  const Sandbox box;
  const auto ends = write_run(box, 4, 40);
  const auto path = frames_in(box);
  std::filesystem::resize_file(path, ends[2] - 1);
  CHECK(read_last_good(path).warning ==
        path.string() + " is cut short at byte " + std::to_string(ends[2] - 1) + " of " +
            std::to_string(ends[3]) +
            ": 2 frames of steps 50 to 75 are lost; the last good frame is step 25, t = 0.25");
}

TEST_CASE("a frame with one wrong byte is noticed, and the one before it is taken") {
  const Sandbox box;
  const auto ends = write_run(box, 4, 200);
  const auto path = frames_in(box);
  const std::string whole = text_of(path);
  std::mt19937 random(7);
  std::uniform_int_distribution<std::uintmax_t> any(ends[2], ends[3] - 1);
  int noticed = 0;
  for (int trial = 0; trial < 200; ++trial) {
    std::string damaged = whole;
    const std::uintmax_t at = any(random);
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << (trial % 8)));
    CAPTURE(at);
    const RecoveredFrames found = read_last_good(box.write("frames.h5", damaged));
    REQUIRE(found.last);
    // A byte that nothing reads (alignment, spare room) may be wrong without harm.
    if (found.last->step == 75) {
      CHECK(same(*found.last, frame_of(75, 230)));
    } else {
      ++noticed;
      CHECK(same(*found.last, frame_of(50, 220)));
      CHECK(found.warning == path.string() +
                                 " is damaged: the frame of step 75 is lost; the last good frame "
                                 "is step 50, t = 0.5");
    }
  }
  CHECK(noticed > 150);
}

TEST_CASE("however a frames file is damaged, what comes back was saved") {
  const Sandbox box;
  write_run(box, 5, 40);
  const std::string whole = text_of(frames_in(box));
  std::mt19937_64 random(11);
  int survived = 0;
  for (int trial = 0; trial < 300; ++trial) {
    std::string damaged = whole;
    for (std::uint64_t n = random() % 5; n > 0; --n) {
      // The headers at the beginning are few bytes, but the ones that hurt.
      damaged[random() % (n % 2 ? damaged.size() : 3000)] = static_cast<char>(random());
    }
    if (trial % 3 == 0) damaged.resize(random() % damaged.size());
    const auto path = box.write("damaged.h5", damaged);
    try {
      const RecoveredFrames found = read_last_good(path);
      if (!found.last) continue;
      ++survived;
      const auto k = found.last->step / 25;
      REQUIRE((k < 5 && found.last->step % 25 == 0));
      CHECK(same(*found.last, frame_of(25 * k, 40 + 10 * k)));
    } catch (const InputError&) {
      continue;  // even the signature is gone
    }
  }
  CHECK(survived > 100);
}

TEST_CASE("good frames behind a damaged one are kept") {
  const Sandbox box;
  const auto ends = write_run(box, 3, 200);
  std::string damaged = text_of(frames_in(box));
  damaged.replace((ends[0] + ends[1]) / 2, 8, 8, '\x5a');
  const RecoveredFrames found = read_last_good(box.write("frames.h5", damaged));
  CHECK(found.steps == std::vector<std::int64_t>{0, 50});
  CHECK(found.last->step == 50);
  CHECK_THAT(found.warning, Contains("the frame of step 25 is lost"));
}

TEST_CASE("nothing is added behind a frame that is no longer what was written") {
  const Sandbox box;
  const auto ends = write_run(box, 3, 200);
  std::string damaged = text_of(frames_in(box));
  // As a file that somebody emptied while a frame was written: the middle is nothing but zeros.
  const auto from = static_cast<std::ptrdiff_t>(ends[0] + 1),
             to = static_cast<std::ptrdiff_t>(ends[2]);
  std::fill(damaged.begin() + from, damaged.begin() + to, '\0');
  box.write("frames.h5", damaged);
  CHECK_THROWS_WITH(append_frame(frames_in(box).parent_path(), frame_of(75, 230)),
                    Contains("frame_000050 is no longer what was written"));
  CHECK(text_of(frames_in(box)) == damaged);
}

TEST_CASE("what never was a frames file is an error, not damage") {
  const Sandbox box;
  const auto refused = [](const std::filesystem::path& path) {
    return refusal([&] { (void)read_last_good(path); });
  };
  CHECK(refused(box / "none.h5") == (box / "none.h5").string() + ": no such file");
  CHECK(refused(box.path()) == box.path().string() + " is a folder; a file was expected");
  const auto words = box.write("words.h5", "not at all");
  CHECK(refused(words) == words.string() + " is not an HDF5 file");
  h5::close_file(h5::create_file(box / "other.h5"), box / "other.h5");
  CHECK(refused(box / "other.h5") ==
        (box / "other.h5").string() +
            " is HDF5 but no frames file: its attribute version is missing");
}

TEST_CASE("what a frames file says of its run agrees with its checksum, or the file is refused") {
  const Sandbox box;
  write_run(box, 2, 20);
  std::string damaged = text_of(frames_in(box));
  const std::size_t at = damaged.find("nu = 1 #");
  REQUIRE(at != std::string::npos);
  damaged[at + 5] = '3';
  const auto path = box.write("damaged.h5", damaged);
  const std::string words =
      path.string() + " is damaged: what it says of its run does not agree with its checksum";
  CHECK(refusal([&] { (void)read_last_good(path); }) == words);
  CHECK(refusal([&] { (void)info_of_frames(path); }) == words);
}

TEST_CASE("a frames file of an earlier version, without a checksum of its run, is read") {
  const Sandbox box;
  write_run(box, 2, 20);
  h5::Handle file = h5::open_file(frames_in(box), H5F_ACC_RDWR);
  REQUIRE(H5Adelete(file, "checksum") >= 0);
  h5::close_file(std::move(file), frames_in(box));
  CHECK(info_of_frames(frames_in(box)) == info);
}

TEST_CASE("a frames file whose beginning is lost says so where its run is asked for") {
  const Sandbox box;
  write_run(box, 2, 20);
  std::string damaged = text_of(frames_in(box));
  damaged.replace(96, 800, 800, '\0');
  const auto path = box.write("damaged.h5", damaged);
  CHECK(refusal([&] { (void)info_of_frames(path); }) ==
        path.string() + " is damaged at its beginning: what it says of its run is lost");
}

// Kills a child that waits to be traced, as it enters or leaves its n-th call of the system.
void kill_at_call(pid_t child, int n) {
  REQUIRE(waitpid(child, nullptr, 0) == child);
  for (int at = 0; at < n; ++at) {
    int status = 0;
    REQUIRE(ptrace(PTRACE_SYSCALL, child, nullptr, nullptr) == 0);
    REQUIRE(waitpid(child, &status, 0) == child);
    REQUIRE(WIFSTOPPED(status));
  }
  kill(child, SIGKILL);
  CHECK(waitpid(child, nullptr, 0) == child);
}

TEST_CASE("a kill loses at most the frame that was being written") {
  const Sandbox box;
  std::mt19937 random(9);
  std::uniform_int_distribution<int> calls(0, 1600);  // a frame takes 200, told of twice
  create_frames(box.path(), info);
  std::int64_t next = 0;
  for (int trial = 0; trial < 15; ++trial) {
    int saved[2];
    REQUIRE(pipe(saved) == 0);
    const pid_t run = fork();
    if (run == 0) {
      if (ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0 || raise(SIGSTOP) != 0) _exit(1);
      for (std::int64_t step = next;; ++step) {
        append_frame(box.path(), frame_of(step, 5000));
        if (write(saved[1], &step, sizeof step) != sizeof step) _exit(1);
      }
    }
    close(saved[1]);
    std::int64_t last_saved = next - 1;
    kill_at_call(run, calls(random));
    for (std::int64_t step; read(saved[0], &step, sizeof step) == sizeof step;) last_saved = step;
    close(saved[0]);
    const RecoveredFrames found = read_last_good(frames_in(box));
    const std::int64_t last = found.last ? found.last->step : -1;
    // The kill may come between a frame and the word that it is saved.
    CHECK((last == last_saved || last == last_saved + 1));
    CHECK(found.steps.size() == static_cast<std::size_t>(last + 1));
    if (found.last) {
      CHECK(same(*found.last, frame_of(last, 5000)));
      rewind_frames(box.path(), last);
    }
    next = last + 1;
  }
  CHECK(next >= 10);  // of some thirty
}
