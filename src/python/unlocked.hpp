#pragma once

#include <omp.h>
#include <pybind11/pybind11.h>

namespace vortree::python {

/// So many OpenMP threads for what this thread computes, as long as it lives; 0: as before.
class ThreadChoice {
 public:
  explicit ThreadChoice(int threads) : before_(omp_get_max_threads()) {
    if (threads > 0) omp_set_num_threads(threads);
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
