#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vortree::app {

struct RunOptions {
  std::string scene;                   // as the user named it; find_scene() gives the file
  std::vector<std::string> overrides;  // table.key=value
  std::filesystem::path out;           // never empty; runs/<scene stem> unless the user chose
  bool resume = false;
  int threads = 0;  // 0: all; OpenMP is already told
};

/// Runs a scene from its start, or from the last frame in `out`, to its end; see README.md for what
/// it leaves in `out`.
///
/// returns  0 done, 1 the run failed or its check did
/// throws   io::InputError for wrong input (exit code 2); any other exception is a failed run (exit
/// code 1)
int run(const RunOptions& options);

}  // namespace vortree::app
