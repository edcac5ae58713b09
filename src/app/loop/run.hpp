#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/methods/methods.hpp"
#include "checks/checks.hpp"

namespace vortree::app {

struct RunOptions {
  std::string scene;                   // as the user named it; find_scene() gives the file
  std::vector<std::string> overrides;  // table.key=value
  std::filesystem::path out;           // never empty; runs/<scene stem> unless the user chose
  bool resume = false;
  bool overwrite = false;  // an older run in `out` may be replaced
  int threads = 0;         // 0: all; OpenMP is already told
  bool figures = true;
  std::vector<std::string> figures_as{};  // of figure_formats(); none: png
};

/// What came of a run.
///
/// finished  false: the user stopped it, it can be resumed
/// seconds   wall time of all its parts; processor_seconds: what all threads have worked
/// threads   of its last part, and where that came from: lines of provenance()
struct RunResult {
  bool finished = false;
  std::vector<checks::Verdict> verdicts{};
  long steps = 0;
  double most_particles = 0, particle_steps = 0, seconds = 0, processor_seconds = 0;
  int threads = 0;
  std::vector<std::string> origin{};

  /// It came to its end and missed nothing that was asked and could be seen by then.
  bool passed() const;
};

/// Runs a scene from its start, or from the last frame in `out`, to its end; see cases/scenes.md
/// for what it leaves in `out`.
///
/// among    the methods that a scene can name
/// throws   io::InputError for wrong input (exit code 2); any other exception is a failed run (exit
/// code 1)
RunResult run(const RunOptions& options, const flow::Methods& among = methods());

}  // namespace vortree::app
