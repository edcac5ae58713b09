#include "app/commands/bench.hpp"

#include <fmt/format.h>

#include <array>
#include <initializer_list>
#include <span>
#include <string_view>
#include <utility>

#include "app/commands/step_flows.hpp"
#include "app/folder/older_run.hpp"
#include "app/folder/output_folder.hpp"
#include "app/plot.hpp"
#include "app/say.hpp"
#include "bench/tables/neighbor_bench.hpp"
#include "bench/tables/neighbor_uses.hpp"
#include "bench/tables/step_bench.hpp"
#include "bench/tables/tree_bench.hpp"
#include "bench/tables/velocity_bench.hpp"
#include "io/files.hpp"
#include "io/frames/read.hpp"

namespace vortree::app {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_moments = 4;

fs::path folder_of(const BenchJob& job, std::string_view what) {
  return job.out.empty() ? fs::path("runs") / fmt::format("bench_{}", what) : job.out;
}

// Tables that a bench may write, and figures that it may draw.
void require_outputs(const fs::path& folder, std::string_view kind,
                     std::initializer_list<const char*> tables, const BenchJob& job,
                     std::span<const fs::path> inputs = {}) {
  for (const char* name : tables) {
    io::require_writable(folder / name, inputs);
    if (!job.overwrite) refuse_older_table(folder / name);
  }
  if (!job.overwrite) refuse_older_figures(folder, kind);
}

void say_row(std::string_view line) {
  tell("{}\n", line);
}

}  // namespace

void bench_velocity(const BenchJob& job) {
  const OutputFolder folder(folder_of(job, "velocity"));
  require_outputs(folder.path(), "velocity", {"velocity.csv"}, job);
  bench::velocity_bench({folder.path() / "velocity.csv", job.quick, job.threads, job.largest},
                        say_row);
  plot(folder.path(), "velocity");
}

void bench_neighbors(const BenchJob& job) {
  const OutputFolder folder(folder_of(job, "neighbors"));
  require_outputs(folder.path(), "neighbors",
                  {"neighbors.csv", "sph.csv", "moving.csv", "cells.csv"}, job);
  bench::neighbor_bench({folder.path() / "neighbors.csv", job.quick, job.threads, job.largest},
                        say_row);
  bench::neighbor_uses(folder.path(), job.quick, job.largest, say_row);
  plot(folder.path(), "neighbors");
}

void bench_step(const BenchJob& job) {
  const auto flows = step_flows(job.runs, job.quick, job.largest);
  const OutputFolder folder(folder_of(job, "step"));
  std::vector<fs::path> inputs;
  for (const fs::path& run : job.runs) inputs.push_back(run / "frames.h5");
  require_outputs(folder.path(), "step", {"step.csv"}, job, inputs);
  bench::step_bench({folder.path() / "step.csv", job.quick, job.threads}, flows, say_row);
  plot(folder.path(), "step");
}

void bench_trees(const BenchJob& job) {
  const OutputFolder folder(folder_of(job, "trees"));
  require_outputs(folder.path(), "trees", {"trees.csv", "trees_reuse.csv"}, job,
                  std::array{job.blobs});
  bench::TreeBench trees{.folder = folder.path(),
                         .quick = job.quick,
                         .threads = job.threads,
                         .largest = job.largest,
                         .flows = {}};
  if (!job.blobs.empty()) {
    const std::vector<io::Frame> frames = io::read_frames(job.blobs, most_moments);
    if (frames.empty()) throw io::InputError(job.blobs.string() + " has no frames");
    for (const io::Frame& frame : frames) {
      const auto column = [&](const char* name) { return flow::column(frame.columns, name); };
      bench::PointSet set{column("x"), column("y"), column("gamma"), column("sigma")};
      if (set.size() > 0) trees.flows.push_back({fmt::format("flow_t{:g}", frame.time), set});
    }
  }
  bench::tree_bench(trees, say_row);
  plot(trees.folder, "trees");
}

}  // namespace vortree::app
