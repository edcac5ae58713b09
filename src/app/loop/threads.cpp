#include "app/loop/threads.hpp"

#include <omp.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

#include "app/say.hpp"

namespace vortree::app {
namespace {

/// Rounds of a spinning thread, some tenths of a millisecond: gaps between loops are shorter.
constexpr const char* rounds = "100000";
/// So much of the time of all threads they wait for cores where little else runs.
constexpr double at_rest = 0.1;
/// Seconds after which it is judged, and for which threads go at most.
constexpr double judged_after = 0.1, longest_rest = 60;
constexpr int most_on_a_processor = 16;

/// Programs that want a core just now, with this one; 0 if nobody knows.
int running() {
  std::ifstream file("/proc/loadavg");
  std::string minutes;
  int count = 0;
  file >> minutes >> minutes >> minutes >> count;
  return file ? count : 0;
}

/// Seconds that this program's threads were ready to run and had no core; 0 if nobody knows.
double waited_for_cores() {
  double nanoseconds = 0;
  std::error_code unknown;
  for (const auto& thread : std::filesystem::directory_iterator("/proc/self/task", unknown)) {
    std::ifstream file(thread.path() / "schedstat");
    double ran = 0, waited = 0;
    if (file >> ran >> waited) nanoseconds += waited;
  }
  return 1e-9 * nanoseconds;
}

}  // namespace

void choose_waiting(char** argv) {
  if (std::getenv("OMP_WAIT_POLICY") || std::getenv("GOMP_SPINCOUNT")) return;
  if (running() == 1)
    setenv("GOMP_SPINCOUNT", rounds, 1);
  else
    setenv("OMP_WAIT_POLICY", "passive", 1);
  execv("/proc/self/exe", argv);
}

void take_threads(int asked) {
  const int wanted = asked > 0 ? asked : omp_get_max_threads();
  const int processors = omp_get_num_procs(), most = most_on_a_processor * processors;
  if (wanted > most)
    say("warning: {} threads are wanted, of {} processors; {} run", wanted, processors, most);
  omp_set_num_threads(std::min(wanted, most));
}

int SharedCores::threads(double seconds, double waited) {
  if (now_ < most_) {
    rest_ -= seconds;
    if (rest_ <= 0) now_ = most_;
  } else if (now_ > 1 && waited > at_rest * most_ * seconds) {
    now_ = std::max(1, most_ / 2);
    rest_ = patience_, patience_ = std::min(2 * patience_, longest_rest);
  } else {
    patience_ = std::max(1.0, patience_ - seconds);
  }
  return now_;
}

ThreadsOfRun::ThreadsOfRun()
    : most_(omp_get_max_threads()), cores_(most_), waited_(waited_for_cores()) {}

ThreadsOfRun::~ThreadsOfRun() {
  omp_set_num_threads(most_);
}

void ThreadsOfRun::after_step() {
  const double now = watch_.elapsed();
  if (now - asked_ < judged_after) return;
  const double waited = waited_for_cores();
  omp_set_num_threads(cores_.threads(now - asked_, waited - waited_));
  asked_ = now, waited_ = waited;
}

}  // namespace vortree::app
