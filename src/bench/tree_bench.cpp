#include "bench/tree_bench.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "app/clock.hpp"
#include "bench/anchors.hpp"
#include "bench/memory.hpp"
#include "bench/provenance.hpp"
#include "bench/tree_rivals.hpp"
#include "fmm/plan.hpp"
#include "tree/build_forward.hpp"
#include "tree/build_reverse.hpp"
#include "tree/radix_sort.hpp"

namespace vortree::bench {
namespace {

constexpr std::uint32_t usual_n_ctrl = 50;  // as in the paper
constexpr double tolerance = 1e-6;

// From points in a domain to a tree, telling its parts.
struct Builder {
  std::string_view name;
  tree::Quadtree (*build)(tree::Points points, const tree::Domain& domain, std::uint32_t n_ctrl,
                          int depth, const TreePhase& phase);
};

using Make = tree::Quadtree (*)(tree::MortonOrder, const tree::SplitRule&);

template <Make make>
tree::Quadtree sorted_first(tree::Points points, const tree::Domain& domain, std::uint32_t n_ctrl,
                            int, const TreePhase& phase) {
  phase("order");
  tree::MortonOrder order = tree::morton_order(points, domain);
  phase("build");
  return make(std::move(order), tree::crowded(n_ctrl));
}

tree::Quadtree climb(tree::MortonOrder order, const tree::SplitRule& crowded) {
  return tree::build_reverse(std::move(order), [&](const tree::Block& b) { return crowded(b); });
}

template <bool known>
tree::Quadtree printed(tree::Points points, const tree::Domain& domain, std::uint32_t n_ctrl,
                       int depth, const TreePhase& phase) {
  phase("order");
  tree::MortonOrder order = tree::morton_order(points, domain);
  phase("build");
  return reverse_as_printed(std::move(order), n_ctrl, known ? depth : tree::max_level);
}

tree::Quadtree partition(tree::Points points, const tree::Domain& domain, std::uint32_t n_ctrl, int,
                         const TreePhase& phase) {
  return forward_by_partition(points, domain, n_ctrl, phase);
}

constexpr Builder builders[] = {
    {"partition", partition},       {"forward", sorted_first<tree::build_forward>},
    {"printed", printed<false>},    {"printed_known", printed<true>},
    {"climb", sorted_first<climb>}, {"reverse", sorted_first<tree::build_reverse>}};

double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t n = values.size();
  return (values[(n - 1) / 2] + values[n / 2]) / 2.0;
}

struct Patience {
  double seconds;
  int most;
  [[nodiscard]] bool more(const std::vector<double>& laps) const {
    double spent = 0.0;
    for (const double lap : laps) spent += lap;
    return laps.size() < 7 || (spent < seconds && static_cast<int>(laps.size()) < most);
  }
};

// Median seconds of some work, done once before to warm up.
template <class Work>
double seconds_of(const Patience& patience, const Work& work) {
  work();
  std::vector<double> laps;
  while (patience.more(laps)) {
    const app::Stopwatch watch;
    work();
    laps.push_back(watch.elapsed());
  }
  return median(laps);
}

struct Made {
  double ready = 0.0, fastest = 0.0;
  std::map<std::string, double> parts;
  std::size_t repeats = 0, kept = 0, cells = 0, childless = 0;
  int depth = 0;
  std::optional<std::size_t> peak;
};

std::size_t bytes_of(const tree::Quadtree& tree) {
  return tree.keys().size_bytes() + tree.order().size_bytes() + tree.cells().size_bytes() +
         tree.childless().size_bytes();
}

// Codes in the order of input.
std::vector<tree::Key> unsorted_codes(tree::Points points) {
  const tree::MortonOrder order = tree::morton_order(points, tree::enclose(points));
  std::vector<tree::Key> keys(order.keys.size());
  for (std::size_t j = 0; j < keys.size(); ++j) keys[order.index[j]] = order.keys[j];
  return keys;
}

// Runs all builders, by turns: what disturbs the machine disturbs all.
class Contest {
 public:
  // domain   empty: found anew each time, as a part of the work
  Contest(tree::Points points, const std::optional<tree::Domain>& domain, std::uint32_t n_ctrl)
      : points_(points),
        domain_(domain),
        n_ctrl_(n_ctrl),
        depth_(tree::build_reverse(
                   tree::morton_order(points, domain ? *domain : tree::enclose(points)),
                   tree::crowded(n_ctrl))
                   .depth()),
        codes_(unsorted_codes(points)) {}

  // By builder; `sort` is the same for all that sort.
  std::map<std::string_view, Made> run(const Patience& patience) {
    std::map<std::string_view, Made> made;
    for (const Builder& builder : builders) measure_memory(builder, made[builder.name]);
    std::map<std::string_view, std::vector<double>> laps;
    std::map<std::string_view, std::map<std::string, std::vector<double>>> parts;
    std::vector<double> sorts;
    run_round(laps, parts, sorts);  // to warm up
    laps.clear(), parts.clear(), sorts.clear();
    while (patience.more(laps["reverse"])) run_round(laps, parts, sorts);
    for (auto& [name, one] : made) {
      one.ready = median(laps[name]);
      one.fastest = std::ranges::min(laps[name]);
      one.repeats = laps[name].size();
      for (auto& [part, values] : parts[name]) one.parts[part] = median(values);
      if (!one.parts.contains("order")) continue;
      one.parts["sort"] = std::min(median(sorts), one.parts["order"]);
      one.parts["encode"] = one.parts["order"] - one.parts["sort"];
    }
    return made;
  }

 private:
  tree::Quadtree lap(const Builder& builder, app::Stopwatch& watch) const {
    watch.begin("enclose");
    const tree::Domain around = domain_ ? *domain_ : tree::enclose(points_);
    tree::Quadtree tree = builder.build(points_, around, n_ctrl_, depth_,
                                        [&](std::string_view name) { watch.begin(name); });
    watch.end();
    return tree;
  }

  void measure_memory(const Builder& builder, Made& made) const {
    const MemoryGrowth growth;
    app::Stopwatch watch;
    const tree::Quadtree tree = lap(builder, watch);
    made.peak = growth.bytes();
    made.kept = bytes_of(tree);
    made.cells = tree.cells().size();
    made.childless = tree.childless().size();
    made.depth = tree.depth();
  }

  void run_round(std::map<std::string_view, std::vector<double>>& laps,
                 std::map<std::string_view, std::map<std::string, std::vector<double>>>& parts,
                 std::vector<double>& sorts) const {
    for (const Builder& builder : builders) {
      app::Stopwatch watch;
      const tree::Quadtree tree = lap(builder, watch);
      double all = 0.0;
      for (const auto& [name, seconds] : watch.phases()) {
        parts[builder.name][name].push_back(seconds);
        all += seconds;
      }
      laps[builder.name].push_back(all);
    }
    std::vector<tree::Key> keys = codes_;
    const app::Stopwatch watch;
    const auto index = tree::radix_sort(keys);
    sorts.push_back(watch.elapsed());
  }

  tree::Points points_;
  std::optional<tree::Domain> domain_;
  std::uint32_t n_ctrl_;
  int depth_;
  std::vector<tree::Key> codes_;
};

// A Plan's evaluation: all of it, its phase "tree", and where that grows its tree.
struct Evaluation {
  double all = 0.0, tree = 0.0;
  tree::Domain domain;
};

Evaluation evaluate(const PointSet& set, std::uint32_t n_ctrl, const Patience& patience) {
  std::vector<double> u(set.size()), v(set.size()), all, tree;
  Evaluation made;
  const auto lap = [&] {
    app::Stopwatch watch;
    const fmm::Plan plan(set.blobs(), {.tolerance = tolerance, .capacity = n_ctrl},
                         [&](std::string_view name) { watch.begin(name); });
    plan.velocity(u, v);
    watch.end();
    made.domain = plan.tree().domain();
    all.push_back(watch.elapsed());
    tree.push_back(watch.seconds("tree"));
  };
  lap();
  all.clear(), tree.clear();
  while (patience.more(all)) lap();
  made.all = median(all);
  made.tree = median(tree);
  return made;
}

class Bench {
 public:
  Bench(const TreeBench& job, const std::function<void(std::string_view)>& say)
      : say_(say),
        trees_(job.folder / "trees.csv"),
        reuse_(job.folder / "trees_reuse.csv"),
        patience_(job.quick ? Patience{0.12, 25} : Patience{0.5, 40}) {
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
      const auto all = Contest(points, {}, n_ctrl).run(patience_);
      std::optional<Evaluation> evaluation;
      std::map<std::string_view, Made> same;  // in the Plan's domain, so that the rest is the same
      if (with_velocity) {
        evaluation = evaluate(set, n_ctrl, patience_);
        same = Contest(points, evaluation->domain, n_ctrl).run(patience_);
      }
      for (const Builder& builder : builders) {
        std::optional<double> velocity, lists;
        if (evaluation) {
          const double own = same["reverse"].ready;  // what the Plan does
          const Made& other = same[builder.name];
          // A sum does not ask for order inside a childless cell.
          const auto finish = other.parts.find("finish");
          velocity = evaluation->all - own + other.ready -
                     (finish == other.parts.end() ? 0.0 : finish->second);
          lists = evaluation->tree - own;
        }
        tell({name, set.size(), n_ctrl, threads}, builder, all.at(builder.name), velocity, lists);
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
              seconds_of(patience_, [&] { return tree::morton_order(points, domain); });
          const double repaired =
              seconds_of(patience_, [&] { return repaired_order(points, domain, before.index); });
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

  void tell(const What& what, const Builder& builder, const Made& made,
            const std::optional<double>& velocity, const std::optional<double>& lists) {
    std::map<std::string, double> parts = made.parts;
    const auto optional = [](const auto& value, const char* form) {
      return value ? fmt::format(fmt::runtime(form), *value) : std::string();
    };
    const double floor = 28.0 * static_cast<double>(what.n) / machine_.at(what.threads).triad;
    write(trees_,
          fmt::format("{},{},{},{},{},{:.6g},{:.6g},{},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g},{},{},{},"
                      "{},{},{:.4g},{},{}",
                      what.set, what.n, what.n_ctrl, builder.name, what.threads, made.ready,
                      made.fastest, made.repeats, parts["enclose"], parts["encode"], parts["sort"],
                      parts["build"], parts["finish"], made.cells, made.childless, made.depth,
                      made.kept, optional(made.peak, "{}"), floor, optional(velocity, "{:.6g}"),
                      optional(lists, "{:.4g}")));
    say_(fmt::format(
        "{:9} {:8} {:6} {:13} {:3} {:9.3f} {:8.3f} {:8.3f} {:8.3f} {:8.3f} {:8.3f}  "
        "{:>11}",
        what.set, what.n, what.n_ctrl, builder.name, what.threads, 1e3 * made.ready,
        1e3 * parts["enclose"], 1e3 * parts["encode"], 1e3 * parts["sort"], 1e3 * parts["build"],
        1e3 * parts["finish"], velocity ? fmt::format("{:.2f}", 1e3 * *velocity) : "-"));
  }

  static void write(std::ofstream& out, std::string_view line) {
    out << line << std::endl;
    if (!out) throw std::runtime_error("the tables of the tree bench cannot be written");
  }

  std::function<void(std::string_view)> say_;
  std::ofstream trees_, reuse_;
  Patience patience_;
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
  keep_freed_memory();
  Bench bench(job, say);
  const std::vector<std::size_t> numbers = sizes(job);
  const std::size_t crowd = std::min<std::size_t>(job.quick ? 100'000 : 1'000'000, numbers.back());
  for (const NamedSet& flow : job.flows) {
    bench.measure_set(flow.name, flow.set, usual_n_ctrl, true);
  }
  for (const std::size_t n : numbers) {
    for (const Kind kind : every_kind) {
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
