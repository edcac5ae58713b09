#include "bench/tables/velocity_bench.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/measures/anchors.hpp"
#include "bench/measures/measure.hpp"
#include "bench/tables/velocity_row.hpp"
#include "provenance/provenance.hpp"

namespace vortree::bench {
namespace {

// What is measured: every tolerance from 1e-2 to 1e-13 with one thread for the sizes in
// `thoroughly`, some for the others and with more threads.
struct Programme {
  std::vector<std::size_t> sizes, thoroughly;
  std::vector<double> some;
  std::size_t only_1e6_from;  // from so many blobs on the tolerance 1e-6 alone
  std::size_t no_direct_from;
  Patience patience;

  [[nodiscard]] std::vector<double> tolerances(std::size_t n, int threads) const {
    if (n >= only_1e6_from) return {1e-6};
    if (threads > 1 || std::ranges::find(thoroughly, n) == thoroughly.end()) return some;
    return {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13};
  }
};

Programme programme(bool quick, std::size_t largest) {
  Programme made{.sizes = {100, 300, 1'000, 3'000, 10'000, 100'000, 1'000'000},
                 .thoroughly = {100'000},
                 .some = {1e-3, 1e-6, 1e-9, 1e-12},
                 .only_1e6_from = 300'000,
                 .no_direct_from = 1'000'000,
                 .patience = {.seconds = 0.05, .most_repeats = 20, .most_pairs = 5e7}};
  if (!quick) {
    made.sizes.insert(made.sizes.end(), {30'000, 300'000, 4'000'000});
    std::ranges::sort(made.sizes);
    made.thoroughly = {1'000, 10'000, 100'000, 1'000'000};
    made.only_1e6_from = made.no_direct_from = 5'000'000;
    made.patience = {.seconds = 0.5, .most_repeats = 50, .most_pairs = 1e9};
  }
  if (largest > 0) std::erase_if(made.sizes, [=](std::size_t n) { return n > largest; });
  return made;
}

class VelocityBenchRun {
 public:
  VelocityBenchRun(const VelocityBench& job, const std::function<void(std::string_view)>& say)
      : job_(job), say_(say), out_(job.csv), programme_(programme(job.quick, job.largest)) {
    const int all = job.threads > 0 ? job.threads : omp_get_max_threads();
    for (const int threads : {1, all}) machine_[threads] = measure_anchors(threads);
    for (const std::string& line : provenance()) note(line);
    for (const auto& [threads, anchors] : machine_)
      note(fmt::format(
          "anchors: threads={} fma={:.4g} divisions={:.4g} single_divisions={:.4g} "
          "triad={:.4g}",
          threads, anchors.fma, anchors.divisions, anchors.single_divisions, anchors.triad));
    write(csv_header());
    say_(spoken_header());
  }

  void measure_set(std::string_view name, const PointSet& set) {
    omp_set_num_threads(machine_.rbegin()->first);
    const Exact exact = exact_velocity(set.blobs(), {set.x, set.y, {}});
    for (const auto& [threads, anchors] : machine_) {
      for (const VelocityMethod& method : methods()) {
        if (!method.bare && set.sigma.empty()) continue;
        if (method.exact && set.size() >= programme_.no_direct_from) continue;
        std::vector<std::optional<double>> asked{std::nullopt};
        if (!method.exact) {
          const auto some = programme_.tolerances(set.size(), threads);
          asked.assign(some.begin(), some.end());
        }
        for (const auto& tolerance : asked)
          measure_one({name, method.name, set.size(), tolerance, threads}, method, set, exact);
      }
    }
  }

  [[nodiscard]] const std::vector<std::size_t>& sizes() const { return programme_.sizes; }

 private:
  void measure_one(const VelocityRow& row, const VelocityMethod& method, const PointSet& set,
                   const Exact& exact) {
    omp_set_num_threads(row.threads);
    try {
      const Measurement made =
          measure(method, set, exact, row.tolerance.value_or(0.5), programme_.patience);
      const Floors least = floors(row, made, machine_.at(row.threads));
      write(csv_line(row, made, least));
      say_(spoken_line(row, made, least));
    } catch (const std::invalid_argument& refused) {
      say_(fmt::format("{:9} {:8} {:7} refuses: {}", row.set, row.n, row.method, refused.what()));
    }
  }

  void note(const std::string& line) { write("# " + line); }

  void write(std::string_view line) {
    out_ << line << std::endl;
    if (!out_) throw std::runtime_error(job_.csv.string() + ": cannot be written");
  }

  VelocityBench job_;
  std::function<void(std::string_view)> say_;
  std::ofstream out_;
  Programme programme_;
  std::map<int, Anchors> machine_;  // by number of threads
};

}  // namespace

void velocity_bench(const VelocityBench& job, const std::function<void(std::string_view)>& say) {
  const int threads = omp_get_max_threads();
  VelocityBenchRun bench(job, say);
  for (const std::size_t n : bench.sizes()) {
    for (const PointKind kind : every_kind)
      bench.measure_set(kind_names[static_cast<std::size_t>(kind)], make_points(kind, n));
    bench.measure_set("blobs", make_blobs(n));
  }
  omp_set_num_threads(threads);
}

}  // namespace vortree::bench
