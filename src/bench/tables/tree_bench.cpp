#include "bench/tables/tree_bench.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "base/clock.hpp"
#include "bench/measures/anchors.hpp"
#include "bench/measures/tree_contest.hpp"
#include "bench/rivals/trees/tree_rivals.hpp"
#include "provenance/provenance.hpp"

namespace vortree::bench {
namespace {

constexpr std::uint32_t usual_n_ctrl = 50;  // as in the paper
constexpr double tolerance = 1e-6;

// Median seconds of some work, done once before to warm up.
template <class Work>
double seconds_of(const LapLimit& limit, const Work& work) {
  work();
  std::vector<double> laps;
  while (limit.more(laps)) {
    const Stopwatch watch;
    work();
    laps.push_back(watch.elapsed());
  }
  return median(laps);
}

class TreeBenchRun {
 public:
  TreeBenchRun(const TreeBench& job, const std::function<void(std::string_view)>& say)
      : say_(say),
        trees_(job.folder / "trees.csv"),
        reuse_(job.folder / "trees_reuse.csv"),
        limit_(job.quick ? LapLimit{0.12, 25} : LapLimit{0.5, 40}) {
    const int all = job.threads > 0 ? job.threads : omp_get_max_threads();
    for (const int threads : {1, all}) machine_[threads] = measure_anchors(threads);
    for (auto* out : {&trees_, &reuse_}) {
      for (const std::string& line : provenance()) write(*out, "# " + line);
      for (const auto& [threads, anchors] : machine_) {
        write(*out, fmt::format("# anchors: threads={} triad={:.4g}", threads, anchors.triad));
      }
    }
    write(trees_,
          "set,n,n_ctrl,builder,threads,ready,fastest,repeats,enclose,encode,sort,build,finish,"
          "cells,childless,depth,kept,peak,floor,velocity,lists");
    write(reuse_, "set,n,stored,step,threads,scratch,repaired");
    say_(
        "set             n n_ctrl builder       thr  ready ms  enclose   encode     sort    build"
        "   finish  velocity ms");
  }

  // with_velocity   measure the evaluation, too
  void measure_set(std::string_view name, const PointSet& set, std::uint32_t n_ctrl,
                   bool with_velocity) {
    const tree::Points points{set.x, set.y};
    for (const auto& [threads, anchors] : machine_) {
      omp_set_num_threads(threads);
      const auto all = tree_contest(points, {}, n_ctrl, limit_);
      std::optional<Evaluation> evaluation;
      // in the Plan's domain, so that the rest of an evaluation is the same
      std::map<std::string_view, TreeMade> same;
      if (with_velocity) {
        evaluation = evaluate(set, tolerance, n_ctrl, limit_);
        same = tree_contest(points, evaluation->domain, n_ctrl, limit_);
      }
      for (const std::string_view builder : tree_builders) {
        std::optional<double> velocity, lists;
        if (evaluation) {
          const double own = same["reverse"].ready;  // what the Plan does
          const TreeMade& other = same[builder];
          // A sum does not ask for order inside a childless cell.
          const auto finish = other.parts.find("finish");
          velocity = evaluation->all - own + other.ready -
                     (finish == other.parts.end() ? 0.0 : finish->second);
          lists = evaluation->tree - own;
        }
        tell({name, set.size(), n_ctrl, threads}, builder, all.at(builder), velocity, lists);
      }
    }
  }

  void measure_reuse(std::string_view name, const PointSet& set, double spacing,
                     const std::vector<double>& steps) {
    for (const bool in_order : {false, true}) {
      std::vector<double> x = set.x, y = set.y;
      tree::MortonOrder before = tree::morton_order({x, y}, tree::enclose({x, y}));
      if (in_order) {
        for (std::size_t j = 0; j < x.size(); ++j) {
          x[j] = set.x[before.index[j]], y[j] = set.y[before.index[j]];
        }
        before = tree::morton_order({x, y}, tree::enclose({x, y}));
      }
      for (const double step : steps) {
        std::vector<double> moved_x = x, moved_y = y;
        displace(moved_x, moved_y, step * spacing);
        const tree::Points points{moved_x, moved_y};
        const tree::Domain domain = tree::enclose(points);
        for (const auto& [threads, anchors] : machine_) {
          omp_set_num_threads(threads);
          const double scratch =
              seconds_of(limit_, [&] { return tree::morton_order(points, domain); });
          const double repaired =
              seconds_of(limit_, [&] { return repaired_order(points, domain, before.index); });
          const std::string_view stored = in_order ? "in_order" : "random";
          write(reuse_, fmt::format("{},{},{},{:g},{},{:.6g},{:.6g}", name, x.size(), stored, step,
                                    threads, scratch, repaired));
          say_(
              fmt::format("{:9} {:8} stored {:8} step {:<5g} thr {}  scratch {:.2f} ms, repaired "
                          "{:.2f} ms",
                          name, x.size(), stored, step, threads, 1e3 * scratch, 1e3 * repaired));
        }
      }
    }
  }

 private:
  struct What {
    std::string_view set;
    std::size_t n;
    std::uint32_t n_ctrl;
    int threads;
  };

  // By normally distributed steps.
  static void displace(std::vector<double>& x, std::vector<double>& y, double deviation) {
    Uniform uniform(4711);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double radius = deviation * std::sqrt(-2.0 * std::log(1.0 - uniform()));
      const double angle = 2.0 * std::numbers::pi * uniform();
      x[i] += radius * std::cos(angle);
      y[i] += radius * std::sin(angle);
    }
  }

  void tell(const What& what, std::string_view builder, const TreeMade& made,
            const std::optional<double>& velocity, const std::optional<double>& lists) {
    std::map<std::string, double> parts = made.parts;
    const auto optional = [](const auto& value, const char* form) {
      return value ? fmt::format(fmt::runtime(form), *value) : std::string();
    };
    const double floor = 28.0 * static_cast<double>(what.n) / machine_.at(what.threads).triad;
    write(trees_,
          fmt::format("{},{},{},{},{},{:.6g},{:.6g},{},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g},{},{},{},"
                      "{},{},{:.4g},{},{}",
                      what.set, what.n, what.n_ctrl, builder, what.threads, made.ready,
                      made.fastest, made.repeats, parts["enclose"], parts["encode"], parts["sort"],
                      parts["build"], parts["finish"], made.cells, made.childless, made.depth,
                      made.kept, optional(made.peak, "{}"), floor, optional(velocity, "{:.6g}"),
                      optional(lists, "{:.4g}")));
    say_(fmt::format(
        "{:9} {:8} {:6} {:13} {:3} {:9.3f} {:8.3f} {:8.3f} {:8.3f} {:8.3f} {:8.3f}  "
        "{:>11}",
        what.set, what.n, what.n_ctrl, builder, what.threads, 1e3 * made.ready,
        1e3 * parts["enclose"], 1e3 * parts["encode"], 1e3 * parts["sort"], 1e3 * parts["build"],
        1e3 * parts["finish"], velocity ? fmt::format("{:.2f}", 1e3 * *velocity) : "-"));
  }

  static void write(std::ofstream& out, std::string_view line) {
    out << line << std::endl;
    if (!out) throw std::runtime_error("the tables of the tree bench cannot be written");
  }

  std::function<void(std::string_view)> say_;
  std::ofstream trees_, reuse_;
  LapLimit limit_;
  std::map<int, Anchors> machine_;  // by number of threads
};

std::vector<std::size_t> sizes(const TreeBench& job) {
  std::vector<std::size_t> sizes{1'000, 10'000, 100'000, 1'000'000};
  if (!job.quick) {
    sizes = {1'000, 3'000, 10'000, 30'000, 100'000, 300'000, 1'000'000, 3'000'000, 10'000'000};
  }
  if (job.largest > 0) std::erase_if(sizes, [&](std::size_t n) { return n > job.largest; });
  return sizes;
}

// A mean distance that blobs of a flow have: their cores overlap.
double spacing_of(const PointSet& set) {
  std::vector<double> sigma = set.sigma;
  std::ranges::nth_element(sigma, sigma.begin() + sigma.size() / 2);
  return sigma[sigma.size() / 2];
}

}  // namespace

void tree_bench(const TreeBench& job, const std::function<void(std::string_view)>& say) {
  const int threads = omp_get_max_threads();
  TreeBenchRun bench(job, say);
  const std::vector<std::size_t> numbers = sizes(job);
  const std::size_t crowd = std::min<std::size_t>(job.quick ? 100'000 : 1'000'000, numbers.back());
  for (const NamedSet& flow : job.flows) {
    bench.measure_set(flow.name, flow.set, usual_n_ctrl, true);
  }
  for (const std::size_t n : numbers) {
    for (const PointKind kind : every_kind) {
      const char* name = kind_names[static_cast<std::size_t>(kind)];
      const PointSet set = make_points(kind, n);
      bench.measure_set(name, set, usual_n_ctrl, n <= 3'000'000);
      if (n != crowd) continue;
      for (const std::uint32_t n_ctrl : {10u, 20u, 100u, 200u}) {
        bench.measure_set(name, set, n_ctrl, false);
      }
      bench.measure_reuse(name, set, 1.0 / std::sqrt(static_cast<double>(n)),
                          {0.0, 0.01, 0.1, 1.0});
    }
  }
  if (!job.flows.empty() && !job.flows.back().set.sigma.empty()) {
    const NamedSet& last = job.flows.back();
    bench.measure_reuse(last.name, last.set, spacing_of(last.set), {0.0, 0.01, 0.1, 1.0});
  }
  omp_set_num_threads(threads);
}

}  // namespace vortree::bench
