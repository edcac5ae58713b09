#include "app/bench.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "app/plot.hpp"
#include "bench/velocity_bench.hpp"
#include "io/files.hpp"
#include "io/input_error.hpp"

namespace vortree::app {

namespace fs = std::filesystem;

void bench_velocity(const BenchJob& job) {
  const fs::path folder = job.out.empty() ? fs::path("runs") / "bench_velocity" : job.out;
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) throw io::InputError(fmt::format("{}: {}", folder.string(), failed.message()));
  const fs::path csv = folder / "velocity.csv";
  io::require_writable(csv);
  bench::velocity_bench({csv, job.quick, job.threads, job.largest}, [](std::string_view line) {
    fmt::print("{}\n", line);
    std::fflush(stdout);
  });
  plot(folder);
}

}  // namespace vortree::app
