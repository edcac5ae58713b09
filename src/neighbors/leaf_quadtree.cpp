#include <algorithm>
#include <array>
#include <vector>

#include "neighbors/exact_pairs.hpp"
#include "neighbors/row_by_row.hpp"
#include "tree/build/build_forward.hpp"
#include "tree/build/split_rule.hpp"

// Compiled without fused operations: see tree/neighbors/pair_rule.hpp.
namespace vortree::neighbors {
namespace {

using tree::PairRule;

// Khorasanizade & Sousa 2019, figure 6: one particle to a childless cell; from the root down,
// whatever cell a square around the particle overlaps. For the rules that look at both reaches, a
// cell knows the largest inside.
class LeafQuadtree : public RowByRow<LeafQuadtree> {
 public:
  void build(const NeighborJob& job) override {
    tree_ = tree::build_forward(tree::morton_order(job.points, tree::enclose(job.points)),
                                tree::crowded(1));
    const auto cells = tree_.cells();
    nodes_.resize(cells.size());
    for (std::size_t c = cells.size(); c-- > 0;) {
      const tree::Cell& cell = cells[c];
      Node& node = nodes_[c];
      node = {tree_.centre(cell), half_side(cell), 0};
      for (std::uint32_t k = cell.children.first; k < cell.children.last; ++k) {
        node.largest = std::max(node.largest, nodes_[k].largest);
      }
      if (!cell.childless()) continue;
      for (std::uint32_t p = cell.points.first; p < cell.points.last; ++p) {
        node.largest = std::max(node.largest, job.reach[tree_.order()[p]]);
      }
    }
  }

  template <PairRule rule>
  void find(const NeighborJob& job, std::size_t i, std::vector<std::int32_t>& row) const {
    const auto cells = tree_.cells();
    std::array<std::uint32_t, 4 * (tree::max_level + 1)> waiting;
    std::size_t count = 0;
    waiting[count++] = 0;
    while (count > 0) {
      const std::uint32_t c = waiting[--count];
      if (!nodes_[c].overlaps<rule>(job.points.x[i], job.points.y[i], job.reach[i])) continue;
      const tree::Cell& cell = cells[c];
      for (std::uint32_t k = cell.children.first; k < cell.children.last; ++k) waiting[count++] = k;
      if (!cell.childless()) continue;
      for (std::uint32_t p = cell.points.first; p < cell.points.last; ++p) {
        const std::size_t j = tree_.order()[p];
        if (j == i || !is_pair<rule>(job, i, j)) continue;
        if (job.listing == tree::Listing::both_ways || keeps(job, i, j)) {
          row.push_back(static_cast<std::int32_t>(j));
        }
      }
    }
  }

 private:
  // Half the side, a little longer: codes are rounded by 2^-20 of a cell of level 31 (sort.hpp),
  // centres and distances from them by some last bits of the coordinates.
  [[nodiscard]] double half_side(const tree::Cell& cell) const {
    const tree::Domain& domain = tree_.domain();
    const double farthest = std::max(std::abs(domain.x0), std::abs(domain.y0)) + domain.side;
    return 0.5 * tree_.side(cell.level) + 0x1p-18 * domain.cell_side(tree::max_level) +
           0x1p-50 * farthest;
  }

  struct Node {
    tree::Centre centre;
    double half;
    double largest;  // reach inside
    template <PairRule rule>
    [[nodiscard]] bool overlaps(double x, double y, double reach) const {
      const double r = tree::pair_reach<rule>(reach, largest) * (1 + 0x1p-50) + half;
      return std::abs(x - centre.x) <= r && std::abs(y - centre.y) <= r;
    }
  };

  tree::Quadtree tree_;
  std::vector<Node> nodes_;
};

}  // namespace

std::unique_ptr<NeighborMethod> make_leaf_quadtree() {
  return std::make_unique<LeafQuadtree>();
}

}  // namespace vortree::neighbors
