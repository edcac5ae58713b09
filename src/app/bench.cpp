#include "app/bench.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "app/plot.hpp"
#include "bench/neighbor_bench.hpp"
#include "bench/neighbor_uses.hpp"
#include "bench/velocity_bench.hpp"
#include "io/files.hpp"
#include "io/input_error.hpp"

namespace vortree::app {

namespace fs = std::filesystem;

namespace {

// The table of a bench in a folder that is there and can be written to.
fs::path table_for(const BenchJob& job, std::string_view what) {
  const fs::path folder =
      job.out.empty() ? fs::path("runs") / fmt::format("bench_{}", what) : job.out;
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) throw io::InputError(fmt::format("{}: {}", folder.string(), failed.message()));
  const fs::path csv = folder / fmt::format("{}.csv", what);
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
  plot(csv.parent_path());
}

void bench_neighbors(const BenchJob& job) {
  const fs::path csv = table_for(job, "neighbors");
  bench::neighbor_bench({csv, job.quick, job.threads, job.largest}, say);
  bench::neighbor_uses(csv.parent_path(), job.quick, say);
  plot(csv.parent_path());
}

}  // namespace vortree::app
