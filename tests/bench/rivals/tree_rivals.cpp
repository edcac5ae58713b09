#include "bench/rivals/trees/tree_rivals.hpp"

#include <omp.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "tree/build/build_forward.hpp"
#include "tree/build/build_reverse.hpp"
#include "tree/clouds.hpp"

using namespace vortree;
using tree::Quadtree;

TEST_CASE("every way to a tree ends in the same tree") {
  const int threads = omp_get_max_threads();
  const auto silent = [](std::string_view) {};
  for (int seed = 0; seed < 3000; ++seed) {
    test::Chance chance(seed);
    const test::Cloud cloud = test::any_cloud(seed % 300 == 0 ? 300000 : 300, chance);
    const tree::Domain domain = tree::enclose(cloud.points());
    const auto n_ctrl = static_cast<std::uint32_t>(chance.whole(1, chance.whole(1, 200)));
    omp_set_num_threads(chance.whole(1, 3));
    const tree::MortonOrder order = tree::morton_order(cloud.points(), domain);
    const Quadtree tree = tree::build_reverse(order, tree::crowded(n_ctrl));
    INFO(cloud.name << " of " << cloud.x.size() << ", n_ctrl " << n_ctrl << ", seed " << seed);
    REQUIRE(tree::build_forward(order, tree::crowded(n_ctrl)) == tree);
    REQUIRE(bench::forward_by_partition(cloud.points(), domain, n_ctrl, silent) == tree);
    REQUIRE(bench::reverse_as_printed(order, n_ctrl, tree::max_level) == tree);
    REQUIRE(bench::reverse_as_printed(order, n_ctrl, std::max(0, tree.depth())) == tree);
  }
  omp_set_num_threads(threads);
}

TEST_CASE("an order repaired after a step is the one from scratch, whatever the step") {
  const int threads = omp_get_max_threads();
  for (int seed = 0; seed < 60; ++seed) {
    test::Chance chance(seed);
    const int n = seed % 12 == 0 ? 200000 : chance.whole(4000, 9000);
    test::Cloud cloud = test::make_cloud(seed % test::cloud_kinds, n, chance);
    const auto before = tree::morton_order(cloud.points(), tree::enclose(cloud.points())).index;
    const double step = std::pow(10.0, chance.whole(-9, 0));
    const int movers = chance.whole(1, 10);
    for (std::size_t i = 0; i < cloud.x.size(); ++i) {
      if (chance.whole(1, movers) > 1) continue;
      cloud.x[i] += step * (chance.real() - 0.5);
      cloud.y[i] += step * (chance.real() - 0.5);
    }
    omp_set_num_threads(chance.whole(1, 3));
    const tree::Domain domain = tree::enclose(cloud.points());
    INFO(cloud.name << " of " << n << ", seed " << seed << ", step " << step);
    REQUIRE(bench::repaired_order(cloud.points(), domain, before) ==
            tree::morton_order(cloud.points(), domain));
  }
  omp_set_num_threads(threads);
}
