#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace vortree::app {

/// What one of several tasks, as of a job array, takes of a list of runs: task k of n the runs k,
/// k + n, k + 2n, ..., counted from 1 on. Neighbors of the list, which cost about the same, go to
/// different tasks.
///
/// tasks  0: there are as many as runs
struct Share {
  std::size_t task = 1, tasks = 0;
};

/// `K/N`, 1 <= K <= N, or `K` alone.
/// throws  std::invalid_argument that says what was expected
Share share_in(const std::string& word);

/// The runs of a list, counted from 0 on, that are a task's; none if there are fewer runs than
/// tasks.
/// throws  io::InputError of a lone K beyond the list
std::vector<std::size_t> runs_of(const Share& share, std::size_t runs);

}  // namespace vortree::app
