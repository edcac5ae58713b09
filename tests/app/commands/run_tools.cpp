#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <regex>
#include <string>
#include <vector>

#include "app/loop/progress.hpp"
#include "app/loop/signals.hpp"
#include "base/clock.hpp"
#include "base/memory.hpp"

using namespace vortree;
using namespace std::chrono_literals;

namespace {

/// A clock that a test sets.
struct SetClock {
  using duration = std::chrono::milliseconds;
  using time_point = std::chrono::time_point<SetClock, duration>;
  static inline duration shown{0};
  static time_point now() { return time_point(shown); }
};

}  // namespace

TEST_CASE(
    "a stopwatch adds up the laps of a phase, keeps the phases in order and loses no time "
    "between") {
  StopwatchBy<SetClock> watch;
  for (int lap = 0; lap < 2; ++lap) {
    watch.begin("convect");
    SetClock::shown += 5ms;
    watch.begin("wall");
    SetClock::shown += 1ms;
  }
  watch.end();
  SetClock::shown += 20ms;
  watch.end();
  CHECK(watch.seconds("convect") == Approx(0.010));
  CHECK(watch.seconds("wall") == Approx(0.002));
  CHECK(watch.elapsed() == Approx(0.032));
  CHECK(watch.seconds("never") == 0.0);
  REQUIRE(watch.phases().size() == 2);
  CHECK(watch.phases()[0].first == "convect");
}

TEST_CASE("peak memory grows by what is touched") {
  const auto before = peak_bytes();
  const std::vector<char> block(64 << 20, 1);
  CHECK(peak_bytes() >= before + (48 << 20));
  CHECK(block.back() == 1);
}

TEST_CASE("progress tells the time left from the flow time done since the start of this process") {
  const app::Progress progress{.step = 320,
                               .time = 3,
                               .dt = 0.01,
                               .start = 2,
                               .end = 4,
                               .particles = 41230,
                               .drift = 1.234e-7};
  CHECK(app::progress_line(progress, 75) ==
        "step 320  t 3/4  dt 0.01  41230 particles  ETA 1:15  drift 1.2e-07");
  CHECK(app::progress_line(progress, 7200).find("ETA 2:00:00") != std::string::npos);
  CHECK(app::progress_line({.end = 1}, 1).find("ETA ?") != std::string::npos);
  CHECK(app::progress_line({.time = 1e-300, .end = 1}, 1).find("ETA ?") != std::string::npos);
}

namespace {

/// What a child writes on standard error.
std::string heard_of(void (*body)()) {
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  const pid_t child = fork();
  if (child == 0) {
    dup2(ends[1], STDERR_FILENO);
    body();
    _exit(0);
  }
  close(ends[1]);
  std::string text;
  for (char byte; read(ends[0], &byte, 1) == 1;) text += byte;
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return text;
}

const app::Progress half_way{.step = 1, .time = 1, .end = 2, .particles = 7, .particle = "blob"};

}  // namespace

TEST_CASE("where standard error is no terminal progress is silent for the first half minute") {
  CHECK(heard_of([] {
          app::ProgressLine line;
          line.show(half_way);
          line.show_line("picture 1 of 2");
          line.clear();
        }) == "");
}

TEST_CASE("then it is whole lines, those of a run with the time of day at which it will end") {
  const std::string log = heard_of([] {
    app::ProgressLine line(false, std::chrono::seconds(0));
    line.show(half_way);
    line.show_line("picture 1 of 2");
  });
  CAPTURE(log);
  CHECK(std::regex_match(log, std::regex("vortree: step 1  t 1/2  dt 0  7 blobs  ETA .*  "
                                         "ends about \\d{4}-\\d\\d-\\d\\d \\d\\d:\\d\\d\n"
                                         "vortree: picture 1 of 2\n")));
}

TEST_CASE("on a terminal it is one line that changes and goes") {
  CHECK(heard_of([] {
          app::ProgressLine line(true, std::chrono::seconds(0));
          line.show_line("picture 1 of 2");
          line.show_line("picture 2 of 2");
        }) == "\r\x1b[Kpicture 1 of 2\r\x1b[Kpicture 2 of 2\r\x1b[K");
}

namespace {

// How a child ends that asks for stops as `body` says.
int status_of(void (*body)()) {
  const pid_t child = fork();
  if (child == 0) {
    body();
    _exit(7);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

}  // namespace

TEST_CASE("the first signal only asks for an end, the second one kills") {
  const int once = status_of([] {
    const app::StopRequest stop;
    const bool before = static_cast<bool>(stop);
    raise(SIGINT);
    _exit(!before && stop && stop.signal() == SIGINT ? 0 : 1);
  });
  CHECK(WIFEXITED(once));
  CHECK(WEXITSTATUS(once) == 0);

  const int twice = status_of([] {
    const app::StopRequest stop;
    raise(SIGINT);
    raise(SIGTERM);
  });
  CHECK(WIFSIGNALED(twice));
  CHECK(WTERMSIG(twice) == SIGTERM);

  const int after = status_of([] {
    { const app::StopRequest stop; }
    raise(SIGINT);
  });
  CHECK(WIFSIGNALED(after));
}
