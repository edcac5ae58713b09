#include "app/bench.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <string_view>
#include <utility>

#include "app/plot.hpp"
#include "bench/neighbor_bench.hpp"
#include "bench/neighbor_uses.hpp"
#include "bench/tree_bench.hpp"
#include "bench/velocity_bench.hpp"
#include "io/files.hpp"
#include "io/input_error.hpp"
#include "io/read_frames.hpp"

namespace vortree::app {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_moments = 4;

fs::path made_folder(const BenchJob& job, std::string_view what) {
  const fs::path folder =
      job.out.empty() ? fs::path("runs") / fmt::format("bench_{}", what) : job.out;
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) throw io::InputError(fmt::format("{}: {}", folder.string(), failed.message()));
  return folder;
}

// The table of a bench in a folder that is there and can be written to.
fs::path table_for(const BenchJob& job, std::string_view what) {
  const fs::path csv = made_folder(job, what) / fmt::format("{}.csv", what);
  io::require_writable(csv);
  return csv;
}

void say(std::string_view line) {
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

}  // namespace

void bench_velocity(const BenchJob& job) {
  const fs::path csv = table_for(job, "velocity");
  bench::velocity_bench({csv, job.quick, job.threads, job.largest}, say);
  plot(csv.parent_path(), "velocity");
}

void bench_neighbors(const BenchJob& job) {
  const fs::path csv = table_for(job, "neighbors");
  bench::neighbor_bench({csv, job.quick, job.threads, job.largest}, say);
  bench::neighbor_uses(csv.parent_path(), job.quick, job.largest, say);
  plot(csv.parent_path(), "neighbors");
}

void bench_trees(const TreeBenchJob& job) {
  bench::TreeBench trees{.folder = made_folder(job, "trees"),
                         .quick = job.quick,
                         .threads = job.threads,
                         .largest = job.largest,
                         .flows = {}};
  if (!job.blobs.empty()) {
    for (io::Frame& frame : io::read_frames(job.blobs, most_moments)) {
      bench::PointSet set{std::move(frame.x), std::move(frame.y), std::move(frame.gamma),
                          std::move(frame.sigma)};
      if (set.size() > 0) trees.flows.push_back({fmt::format("flow_t{:g}", frame.time), set});
    }
  }
  for (const char* name : {"trees.csv", "trees_reuse.csv"})
    io::require_writable(trees.folder / name);
  bench::tree_bench(trees, say);
  plot(trees.folder, "trees");
}

}  // namespace vortree::app
