#include "bench/tables/step_bench.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <omp.h>

#include <fstream>
#include <set>
#include <stdexcept>

#include "provenance/provenance.hpp"

namespace vortree::bench {
namespace {

StepPatience patience(bool quick) {
  return quick ? StepPatience{.steps = 4, .seconds = 0.2, .most_repeats = 5} : StepPatience{};
}

/// A word that holds a comma is quoted.
std::string cell(const std::string& word) {
  return word.find(',') == std::string::npos ? word : '"' + word + '"';
}

std::string words_of_counts(const flow::Measures& counts) {
  std::vector<std::string> parts;
  for (const flow::Measure& one : counts)
    parts.push_back(fmt::format("{}={:.6g}", one.name, one.value));
  return fmt::format("{}", fmt::join(parts, ";"));
}

/// Whose steps they are, and by how many threads.
struct StepRow {
  const StepFlow& flow;
  const std::string& variant;
  int threads;
};

double nanoseconds(const StepMeasure& made, double seconds) {
  return 1e9 * seconds / made.particles;
}

std::string csv_row(const StepRow& row, const StepMeasure& made, std::string_view phase,
                    double seconds) {
  return fmt::format("{},{},{},{},{:.6g},{:.6g},{:.6g},{:.6g},{},{},{}", cell(row.flow.name),
                     row.variant, row.threads, phase, nanoseconds(made, seconds),
                     seconds / made.seconds(), seconds / made.steps, made.particles / made.steps,
                     row.flow.panels, made.steps, made.repeats);
}

std::string row_of_step(const StepRow& row, const StepMeasure& made) {
  return fmt::format("{},{:.6g},{},{}", csv_row(row, made, "step", made.seconds()),
                     made.particles / made.seconds(),
                     made.drag ? fmt::format("{:.9g}", *made.drag) : "",
                     words_of_counts(made.counts));
}

std::string spoken(const StepRow& row, const StepMeasure& made) {
  std::string line =
      fmt::format("{:20} {:9} {:3} {:8.0f} {:9.0f} {:8.3f} ", row.flow.name, row.variant,
                  row.threads, made.particles / made.steps, nanoseconds(made, made.seconds()),
                  1e-6 * made.particles / made.seconds());
  for (const auto& [phase, seconds] : made.phases)
    line += fmt::format(" {} {:.0f}", phase, nanoseconds(made, seconds));
  return line;
}

class StepBenchRun {
 public:
  StepBenchRun(const StepBench& job, const std::function<void(std::string_view)>& say)
      : job_(job), say_(say), out_(job.csv) {
    threads_ = {1, job.threads > 0 ? job.threads : omp_get_max_threads()};
    for (const std::string& line : provenance()) write("# " + line);
    write(
        "flow,variant,threads,phase,ns,share,seconds,blobs,panels,steps,repeats,particle_steps,"
        "drag,"
        "counts");
    say_(
        "flow                 variant   thr    blobs ns a blob  million/s  ns a blob and step by "
        "phase");
  }

  /// As many as may be, for what comes before the measuring.
  void take_all_threads() const { omp_set_num_threads(*threads_.rbegin()); }

  void measure_flow(const StepFlow& flow) {
    std::vector<std::unique_ptr<flow::Solver>> owned;
    for (const StepVariant& variant : flow.variants) owned.push_back(variant.begin());
    std::vector<flow::Solver*> solvers;
    for (const auto& solver : owned) solvers.push_back(solver.get());
    for (const int threads : threads_) {
      omp_set_num_threads(threads);
      const auto made = measure_steps(solvers, flow.from, flow.scales, patience(job_.quick));
      for (std::size_t k = 0; k < made.size(); ++k)
        tell({flow, flow.variants[k].name, threads}, made[k]);
    }
  }

 private:
  void tell(const StepRow& row, const StepMeasure& made) {
    for (const auto& [phase, seconds] : made.phases)
      write(csv_row(row, made, phase, seconds) + ",,,");
    write(row_of_step(row, made));
    say_(spoken(row, made));
  }

  void write(std::string_view line) {
    out_ << line << std::endl;
    if (!out_) throw std::runtime_error(job_.csv.string() + ": cannot be written");
  }

  StepBench job_;
  std::function<void(std::string_view)> say_;
  std::ofstream out_;
  std::set<int> threads_;
};

}  // namespace

void step_bench(const StepBench& job, std::span<const std::function<StepFlow()>> flows,
                const std::function<void(std::string_view)>& say) {
  const int threads = omp_get_max_threads();
  StepBenchRun bench(job, say);
  for (const auto& make : flows) {
    bench.take_all_threads();
    bench.measure_flow(make());
  }
  omp_set_num_threads(threads);
}

}  // namespace vortree::bench
