#include "bench/measures/tree_contest.hpp"

#include <algorithm>
#include <utility>

#include "base/clock.hpp"
#include "bench/measures/memory.hpp"
#include "bench/rivals/trees/tree_rivals.hpp"
#include "fmm/plan.hpp"
#include "tree/build/build_forward.hpp"
#include "tree/build/build_reverse.hpp"
#include "tree/order/radix_sort.hpp"

namespace vortree::bench {
namespace {

// From points in a domain to a tree, telling its parts.
struct Contestant {
  std::string_view name;
  tree::Quadtree (*build)(tree::Points points, const tree::Domain& domain, std::uint32_t n_ctrl,
                          int depth, const tree::Phase& phase);
};

using Make = tree::Quadtree (*)(tree::MortonOrder, const tree::SplitRule&);

template <Make make>
tree::Quadtree sorted_first(tree::Points points, const tree::Domain& domain, std::uint32_t n_ctrl,
                            int, const tree::Phase& phase) {
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
                       int depth, const tree::Phase& phase) {
  phase("order");
  tree::MortonOrder order = tree::morton_order(points, domain);
  phase("build");
  return reverse_as_printed(std::move(order), n_ctrl, known ? depth : tree::max_level);
}

tree::Quadtree partition(tree::Points points, const tree::Domain& domain, std::uint32_t n_ctrl, int,
                         const tree::Phase& phase) {
  return forward_by_partition(points, domain, n_ctrl, phase);
}

constexpr Contestant builders[] = {
    {tree_builders[0], partition},           {tree_builders[1], sorted_first<tree::build_forward>},
    {tree_builders[2], printed<false>},      {tree_builders[3], printed<true>},
    {tree_builders[4], sorted_first<climb>}, {tree_builders[5], sorted_first<tree::build_reverse>}};

std::size_t bytes_of(const tree::Quadtree& tree) {
  return tree.keys().size_bytes() + tree.order().size_bytes() + tree.cells().size_bytes() +
         tree.childless().size_bytes();
}

// Codes in the order of input.
std::vector<tree::MortonKey> unsorted_codes(tree::Points points) {
  const tree::MortonOrder order = tree::morton_order(points, tree::enclose(points));
  std::vector<tree::MortonKey> keys(order.keys.size());
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
  std::map<std::string_view, TreeMade> run(const LapLimit& limit) {
    std::map<std::string_view, TreeMade> made;
    for (const Contestant& builder : builders) measure_memory(builder, made[builder.name]);
    std::map<std::string_view, std::vector<double>> laps;
    std::map<std::string_view, std::map<std::string, std::vector<double>>> parts;
    std::vector<double> sorts;
    run_round(laps, parts, sorts);  // to warm up
    laps.clear(), parts.clear(), sorts.clear();
    while (limit.more(laps["reverse"])) run_round(laps, parts, sorts);
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
  tree::Quadtree lap(const Contestant& builder, Stopwatch& watch) const {
    watch.begin("enclose");
    const tree::Domain around = domain_ ? *domain_ : tree::enclose(points_);
    tree::Quadtree tree = builder.build(points_, around, n_ctrl_, depth_,
                                        [&](std::string_view name) { watch.begin(name); });
    watch.end();
    return tree;
  }

  void measure_memory(const Contestant& builder, TreeMade& made) const {
    const MemoryGrowth growth;
    Stopwatch watch;
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
    for (const Contestant& builder : builders) {
      Stopwatch watch;
      const tree::Quadtree tree = lap(builder, watch);
      double all = 0.0;
      for (const auto& [name, seconds] : watch.phases()) {
        parts[builder.name][name].push_back(seconds);
        all += seconds;
      }
      laps[builder.name].push_back(all);
    }
    std::vector<tree::MortonKey> keys = codes_;
    const Stopwatch watch;
    const auto index = tree::radix_sort(keys);
    sorts.push_back(watch.elapsed());
  }

  tree::Points points_;
  std::optional<tree::Domain> domain_;
  std::uint32_t n_ctrl_;
  int depth_;
  std::vector<tree::MortonKey> codes_;
};

}  // namespace

bool LapLimit::more(const std::vector<double>& laps) const {
  double spent = 0.0;
  for (const double lap : laps) spent += lap;
  return laps.size() < 7 || (spent < seconds && static_cast<int>(laps.size()) < most);
}

std::map<std::string_view, TreeMade> tree_contest(tree::Points points,
                                                  const std::optional<tree::Domain>& domain,
                                                  std::uint32_t n_ctrl, const LapLimit& limit) {
  return Contest(points, domain, n_ctrl).run(limit);
}

Evaluation evaluate(const PointSet& set, double tolerance, std::uint32_t n_ctrl,
                    const LapLimit& limit) {
  std::vector<double> u(set.size()), v(set.size()), all, tree;
  Evaluation made;
  const auto lap = [&] {
    Stopwatch watch;
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
  while (limit.more(all)) lap();
  made.all = median(all);
  made.tree = median(tree);
  return made;
}

}  // namespace vortree::bench
