#include "app/bench.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <string_view>
#include <utility>

#include "app/plot.hpp"
#include "bench/tree_bench.hpp"
#include "bench/velocity_bench.hpp"
#include "io/files.hpp"
#include "io/input_error.hpp"
#include "io/read_frames.hpp"

namespace vortree::app {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_moments = 4;

fs::path made_folder(const fs::path& wished, const char* usual) {
  const fs::path folder = wished.empty() ? fs::path("runs") / usual : wished;
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) throw io::InputError(fmt::format("{}: {}", folder.string(), failed.message()));
  return folder;
}

void say(std::string_view line) {
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

}  // namespace

void bench_velocity(const BenchJob& job) {
  const fs::path folder = made_folder(job.out, "bench_velocity");
  const fs::path csv = folder / "velocity.csv";
  io::require_writable(csv);
  bench::velocity_bench({csv, job.quick, job.threads, job.largest}, say);
  plot(folder);
}

void bench_trees(const TreeBenchJob& job) {
  bench::TreeBench trees{.folder = made_folder(job.out, "bench_trees"),
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
  plot(trees.folder);
}

}  // namespace vortree::app
