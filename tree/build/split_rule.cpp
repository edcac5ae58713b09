#include "tree/build/split_rule.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tree/base/told.hpp"
#include "tree/base/tuning.hpp"

namespace vortree::tree {

namespace {

bool acceptable(double reach) {
  return reach >= 0 && std::isfinite(reach);
}

[[noreturn]] void refuse_reach(const std::string& which, double reach) {
  throw std::invalid_argument("roomy: " + which + " is " + told(reach) +
                              "; it must be finite and >= 0");
}

// Minima over runs of 16^k values, k = 0, 1, ...: the minimum of any range in O(16 log n).
class Minima {
 public:
  explicit Minima(std::span<const double> values) : floors_{{values.begin(), values.end()}} {
    while (floors_.back().size() > 1) {
      const std::vector<double>& below = floors_.back();
      std::vector<double> floor((below.size() + reaches_a_node - 1) / reaches_a_node);
      for (std::size_t i = 0; i < floor.size(); ++i) {
        floor[i] =
            smallest(below, i * reaches_a_node, std::min(below.size(), (i + 1) * reaches_a_node));
      }
      floors_.push_back(std::move(floor));
    }
  }

  [[nodiscard]] std::size_t size() const { return floors_.front().size(); }

  [[nodiscard]] double over(Range range) const {
    double least = INFINITY;
    std::size_t first = range.first, last = range.last;
    for (const std::vector<double>& floor : floors_) {
      const std::size_t first_whole = (first + reaches_a_node - 1) / reaches_a_node,
                        last_whole = last / reaches_a_node;
      if (first_whole >= last_whole) {
        return std::min(least, smallest(floor, first, last));
      }
      least = std::min(least, smallest(floor, first, first_whole * reaches_a_node));
      least = std::min(least, smallest(floor, last_whole * reaches_a_node, last));
      first = first_whole;
      last = last_whole;
    }
    return least;
  }

 private:
  static double smallest(const std::vector<double>& values, std::size_t first, std::size_t last) {
    double least = INFINITY;
    for (std::size_t i = first; i < last; ++i) {
      least = std::min(least, values[i]);
    }
    return least;
  }

  std::vector<std::vector<double>> floors_;
};

void check_rules(const char* name, const SplitRule& a, const SplitRule& b) {
  if (!a || !b) {
    throw std::invalid_argument(std::string(name) + ": a split rule is empty");
  }
}

}  // namespace

SplitRule crowded(std::uint32_t n_ctrl) {
  if (n_ctrl == 0) {
    throw std::invalid_argument("crowded: n_ctrl is 0; a cell must be allowed one point");
  }
  return CrowdedRule{n_ctrl};
}

SplitRule roomy(std::span<const double> reach) {
  const auto bad = std::find_if_not(reach.begin(), reach.end(), acceptable);
  if (bad != reach.end()) {
    refuse_reach("reach[" + std::to_string(bad - reach.begin()) + "]", *bad);
  }
  return [minima = Minima(reach)](const Block& block) {
    if (block.points.last > minima.size()) {
      throw std::invalid_argument("roomy: a block ends at point " +
                                  std::to_string(block.points.last) + " but there are only " +
                                  std::to_string(minima.size()) + " reaches");
    }
    return block.side / 2 >= minima.over(block.points);
  };
}

SplitRule roomy(double reach) {
  if (!acceptable(reach)) {
    refuse_reach("reach", reach);
  }
  return [reach](const Block& block) { return block.side / 2 >= reach; };
}

SplitRule either(SplitRule a, SplitRule b) {
  check_rules("either", a, b);
  return [a = std::move(a), b = std::move(b)](const Block& block) { return a(block) || b(block); };
}

SplitRule both(SplitRule a, SplitRule b) {
  check_rules("both", a, b);
  return [a = std::move(a), b = std::move(b)](const Block& block) { return a(block) && b(block); };
}

}  // namespace vortree::tree
