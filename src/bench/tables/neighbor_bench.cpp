#include "bench/tables/neighbor_bench.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "bench/measures/anchors.hpp"
#include "bench/measures/neighbor_measure.hpp"
#include "provenance/provenance.hpp"

namespace vortree::bench {
namespace {

using tree::Listing;
using tree::PairRule;

constexpr std::array rule_names{"max", "mean", "own"};
constexpr std::array order_names{"shuffled", "sorted", "made"};

struct Set {
  std::string_view family;
  std::string name;
};

// The sets, small ones of a family first.
std::vector<Set> every_set(bool quick) {
  std::vector<Set> sets;
  for (const char* name : {"cyl:1:100", "cyl:2:100", "cyl:3:100", "cyl:4:100", "cyl:5:100"})
    sets.push_back({"levels", name});
  for (const char* name : {"cyl:1:200", "cyl:1:400"}) sets.push_back({"refined", name});
  for (const char* name : {"foil:5:150", "foil:6:150", "foil:7:150"})
    sets.push_back({"foil", name});
  for (const char* name : {"cyl:5:17", "cyl:5:55", "cyl:5:174", "cyl:5:549", "cyl:5:1098"})
    sets.push_back({"scaled", name});
  for (const char* name : {"uni:32", "uni:100", "uni:316", "uni:1000", "uni:2000"})
    sets.push_back({"uniform", name});
  if (quick) return sets;
  for (const char* name : {"cyl:5:31", "cyl:5:310"}) sets.push_back({"scaled", name});
  for (const char* name : {"uni:56", "uni:178", "uni:562"}) sets.push_back({"uniform", name});
  return sets;
}

// What is asked of each set.
struct Question {
  Order order;
  PairRule rule;
  Listing listing;
  bool several;  // threads
  bool all;      // of every method, not only of the two fastest
};

std::vector<Question> questions(bool quick) {
  using enum Order;
  using enum PairRule;
  using enum Listing;
  std::vector<Question> asked{
      {shuffled, max, both_ways, false, true},   {shuffled, max, once, false, true},
      {sorted, max, both_ways, false, false},    {sorted, max, once, false, false},
      {sorted, max, both_ways, true, false},     {shuffled, max, both_ways, true, false},
      {shuffled, mean, both_ways, false, false}, {shuffled, own, both_ways, false, false}};
  if (!quick) {
    asked.push_back({shuffled, mean, once, false, false});
    asked.push_back({sorted, max, once, true, false});
    asked[2].all = true;
  }
  return asked;
}

class NeighborBenchRun {
 public:
  NeighborBenchRun(const NeighborBench& job, const std::function<void(std::string_view)>& say)
      : job_(job), say_(say), out_(job.csv) {
    several_ = job.threads > 0 ? job.threads : omp_get_max_threads();
    patience_ = job.quick ? 0.03 : 0.5;
    longest_ = job.quick ? 0.5 : 60.0;
    largest_ = job.largest > 0 ? job.largest : job.quick ? 1'100'000 : 5'000'000;
    for (const std::string& line : provenance()) write("# " + line);
    for (const int threads : {1, several_}) {
      const Anchors machine = machine_[threads] = measure_anchors(threads);
      write(
          fmt::format("# anchors: threads={} fma={:.4g} divisions={:.4g} triad={:.4g} write={:.4g}",
                      threads, machine.fma, machine.divisions, machine.triad, machine.write));
    }
    write(
        "family,set,order,n,levels,method,rule,listing,threads,build,search,seconds,fastest,"
        "repeats,cpu,pairs,bytes,list_bytes,write_share");
    say_(
        "set        order    n        method        rule listing threads    ns a particle:"
        "  build   search    total   bytes beyond the list   share of the write bound");
  }

  void measure_set(const Set& set) {
    found_.clear();
    std::map<Order, ParticleSet> made;
    for (const Question& question : questions(job_.quick)) {
      if (!made.contains(question.order)) {
        made[question.order] = make_particles(set.name, question.order);
      }
      const ParticleSet& particles = made[question.order];
      if (particles.size() > largest_) return;
      if (job_.quick && question.rule != PairRule::max && particles.size() > 200'000) continue;
      if (question.several && several_ == 1) continue;
      for (const neighbors::NeighborMaker& maker : neighbors::makers()) {
        const bool fast = maker.name() == "qcg" || maker.name() == "level-grids";
        if (question.all || fast) measure_one(set, question, particles, maker);
      }
    }
  }

  // How time grows with n, where there are sets enough to tell.
  void say_exponents() const {
    for (const auto& [what, costs] : costs_) {
      const auto& [family, method, order, listing, threads] = what;
      if (family != "scaled" && family != "uniform") continue;
      const std::optional<Slope> slope = fit_slope(costs);
      if (!slope) continue;
      say_(fmt::format("{:8} {:13} {:8} {:4} {} threads: time ~ n^{:.3f} from {:.0f} to {:.0f}",
                       family, method, order, listing, threads, slope->exponent, slope->from,
                       slope->to));
    }
  }

 private:
  void measure_one(const Set& set, const Question& question, const ParticleSet& particles,
                   const neighbors::NeighborMaker& maker) {
    const neighbors::NeighborJob job{particles.points(), particles.reach, question.rule,
                                     question.listing};
    if (expected_seconds(maker, job) > longest_) return;
    const int threads = question.several ? several_ : 1;
    omp_set_num_threads(threads);
    const NeighborMeasurement made = measure_neighbors(maker, job, patience_);
    compare(set, question, maker, made.found);
    const double n = static_cast<double>(particles.size());
    const std::string_view listing = question.listing == Listing::once ? "once" : "both";
    const auto order = order_names[static_cast<std::size_t>(question.order)];
    const auto rule = rule_names[static_cast<std::size_t>(question.rule)];
    const int levels = 1 + *std::ranges::max_element(particles.level);
    // Writing the list alone takes so much of the time.
    const double share =
        static_cast<double>(made.list_bytes) / machine_[threads].write / made.total;
    const std::string bytes = made.bytes ? fmt::format("{}", *made.bytes) : "";
    write(fmt::format(
        "{},{},{},{},{},{},{},{},{},{:.6g},{:.6g},{:.6g},{:.6g},{},{:.3f},{},{},{},{:.4f}",
        set.family, set.name, order, particles.size(), levels, maker.name(), rule, listing, threads,
        made.build, made.search, made.total, made.fastest, made.repeats, made.cpu, made.found.pairs,
        bytes, made.list_bytes, share));
    const double beyond = static_cast<double>(made.bytes.value_or(made.list_bytes)) -
                          static_cast<double>(made.list_bytes);
    say_(fmt::format("{:10} {:8} {:8} {:13} {:4} {:7} {:7} {:23.1f} {:8.1f} {:8.1f} {:7.0f} {:.3f}",
                     set.name, order, particles.size(), maker.name(), rule, listing, threads,
                     1e9 * made.build / n, 1e9 * made.search / n, 1e9 * made.total / n, beyond / n,
                     share));
    if (question.rule == PairRule::max) {
      costs_[{set.family, maker.name(), order, listing, threads}].push_back({n, made.fastest});
    }
  }

  // Every method lists the same pairs, one thread or several.
  void compare(const Set& set, const Question& question, const neighbors::NeighborMaker& maker,
               const Fingerprint& found) {
    const auto [first, is_new] =
        found_.emplace(std::tuple(question.order, question.rule, question.listing), found);
    if (!is_new && !(first->second == found)) {
      throw std::runtime_error(fmt::format("{} lists other pairs of {} than the method before it",
                                           maker.name(), set.name));
    }
  }

  void write(std::string_view line) {
    out_ << line << std::endl;
    if (!out_) throw std::runtime_error(job_.csv.string() + ": cannot be written");
  }

  NeighborBench job_;
  std::function<void(std::string_view)> say_;
  std::ofstream out_;
  int several_;
  double patience_, longest_;
  std::map<int, Anchors> machine_;  // by number of threads
  // By family, method, order, listing and threads.
  using What =
      std::tuple<std::string_view, std::string_view, std::string_view, std::string_view, int>;
  std::map<What, std::vector<NeighborCost>> costs_;
  std::size_t largest_;
  std::map<std::tuple<Order, PairRule, Listing>, Fingerprint> found_;
};

}  // namespace

void neighbor_bench(const NeighborBench& job, const std::function<void(std::string_view)>& say) {
  const int threads = omp_get_max_threads();
  NeighborBenchRun bench(job, say);
  for (const Set& set : every_set(job.quick)) bench.measure_set(set);
  bench.say_exponents();
  omp_set_num_threads(threads);
}

}  // namespace vortree::bench
