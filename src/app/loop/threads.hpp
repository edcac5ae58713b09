#pragma once

#include "base/clock.hpp"

namespace vortree::app {

/// How OpenMP threads wait for each other, unless the environment says it: where nothing else runs
/// as the program begins they spin for a moment, else they sleep.
///
/// A step of some ten thousand particles makes a hundred short loops that threads share; on two
/// idle cores a spinning thread makes it 1.5 times as fast as one thread, one that has to be woken
/// hardly faster. But a thread that spins keeps the core from the one it waits for: with other
/// programs on the machine, steps took five to seventy times as long (SharedCores).
///
/// argv  of main; the program starts itself once more, since OpenMP reads its environment before
/// main
void choose_waiting(char** argv);

/// Has OpenMP take so many threads, or as many as the environment says if that is 0; never more
/// than 16 for each processor, which it warns of: they would wait for each other, and of a hundred
/// thousand the system makes none.
void take_threads(int asked);

/// How many threads are good to have, while other programs may come and go: where threads wait for
/// cores, half of them go for a while, each time for longer; then they are tried again.
class SharedCores {
 public:
  explicit SharedCores(int most) : most_(most), now_(most) {}

  /// seconds   since it was asked last
  /// waited    seconds that threads were ready meanwhile and had no core, of all together
  int threads(double seconds, double waited);

 private:
  int most_, now_;
  double rest_ = 0, patience_ = 1;
};

/// OpenMP's threads, as many as SharedCores has for them. Results have the same bits for any
/// number.
class ThreadsOfRun {
 public:
  ThreadsOfRun();
  ~ThreadsOfRun();
  ThreadsOfRun(const ThreadsOfRun&) = delete;
  ThreadsOfRun& operator=(const ThreadsOfRun&) = delete;

  void after_step();

 private:
  int most_;
  SharedCores cores_;
  Stopwatch watch_;
  double asked_ = 0, waited_;
};

}  // namespace vortree::app
