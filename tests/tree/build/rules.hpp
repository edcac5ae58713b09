#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "tree/build/split_rule.hpp"
#include "tree/clouds.hpp"
#include "tree/order/sort.hpp"

namespace vortree::test {

struct NamedRule {
  std::string name;
  tree::SplitRule must_split;
};

inline std::vector<double> random_reach(std::size_t n, double side, Chance& chance) {
  std::vector<double> reach(n);
  for (double& r : reach) {
    r = side * std::pow(2.0, -12 * chance.real());
  }
  return reach;
}

/// A rule of the test's own: every point wants its cell to be at least so deep. Any tree of
/// occupied cells can come out of it, chains included. Monotone: inside a block the deepest wish
/// only falls.
inline tree::SplitRule wishes(std::vector<int> level) {
  return [level = std::move(level)](const tree::Block& block) {
    const auto first = level.begin() + block.points.first, last = level.begin() + block.points.last;
    return block.level < *std::max_element(first, last);
  };
}

inline NamedRule any_rule(const tree::MortonOrder& order, Chance& chance, int nesting = 0) {
  const std::size_t n = order.keys.size();
  const double side = order.domain.side;
  switch (chance.whole(0, nesting < 2 ? 5 : 3)) {
    case 0: {
      const int n_ctrl = chance.whole(0, 1) == 0 ? chance.whole(1, 8) : chance.whole(1, 100);
      return {"crowded " + std::to_string(n_ctrl), tree::crowded(n_ctrl)};
    }
    case 1:
      return {"roomy for each", tree::roomy(random_reach(n, side, chance))};
    case 2:
      return {"roomy for all", tree::roomy(side * std::pow(2.0, -8 * chance.real()))};
    case 3: {
      std::vector<int> level(n);
      const int mean = chance.whole(0, tree::max_level);
      for (int& l : level) {
        l = chance.whole(0, 3) == 0 ? mean : chance.whole(0, 6);
      }
      return {"wishes", wishes(std::move(level))};
    }
    default:
      break;
  }
  NamedRule a = any_rule(order, chance, nesting + 1), b = any_rule(order, chance, nesting + 1);
  const std::string names = "(" + a.name + ", " + b.name + ")";
  if (chance.whole(0, 1) == 0) {
    return {"either" + names, tree::either(std::move(a.must_split), std::move(b.must_split))};
  }
  return {"both" + names, tree::both(std::move(a.must_split), std::move(b.must_split))};
}

}  // namespace vortree::test
