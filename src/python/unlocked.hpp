#pragma once

#include <omp.h>
#include <pybind11/pybind11.h>
#include <unistd.h>

namespace vortree::python {

/// The process that has loaded the module. One that was forked from it, as multiprocessing does,
/// has not got its OpenMP threads, and would wait for them for ever.
inline const pid_t loaded_by = ::getpid();

/// So many OpenMP threads for what this thread computes, as long as it lives; 0: as before. One in
/// a process that was forked.
class ThreadChoice {
 public:
  explicit ThreadChoice(int threads) : before_(omp_get_max_threads()) {
    const int good = ::getpid() == loaded_by ? threads : 1;
    if (good > 0) omp_set_num_threads(good);
  }
  ~ThreadChoice() { omp_set_num_threads(before_); }
  ThreadChoice(const ThreadChoice&) = delete;
  ThreadChoice& operator=(const ThreadChoice&) = delete;

 private:
  int before_;
};

/// Works while other threads of Python run on. The work touches no object of Python.
template <class Work>
decltype(auto) unlocked(int threads, const Work& work) {
  const pybind11::gil_scoped_release others_run;
  const ThreadChoice choice(threads);
  return work();
}

}  // namespace vortree::python
