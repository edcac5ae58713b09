#pragma once

#include <CLI/App.hpp>
#include <memory>
#include <string>
#include <vector>

#include "app/commands/bench.hpp"
#include "app/commands/lyapunov.hpp"
#include "app/commands/movie.hpp"
#include "app/commands/neighbors.hpp"
#include "app/commands/velocity.hpp"
#include "app/commands/view.hpp"
#include "app/loop/run.hpp"

namespace vortree::app {

/// All that a command line can say.
struct Words {
  RunOptions run;
  std::string only;
  VelocityJob velocity;
  NeighborsJob neighbors;
  LyapunovJob lyapunov;
  MovieJob movie;
  ViewJob view;
  BenchJob bench;
  std::string benched;
  std::string scene;
  std::vector<std::string> overrides;
  bool keys = false;
  std::string folder;
  int threads = 0;
};

/// The command line as it is declared: commands, their options, what each may be, and what help
/// says of it. Parsing fills in the words, which have to outlive it.
std::unique_ptr<CLI::App> grammar(Words& words);

}  // namespace vortree::app
