#include "neighbors/methods.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "tree/neighbors/neighbors.hpp"

namespace vortree::neighbors {
namespace {

class Qcg : public NeighborMethod {
 public:
  void build(const NeighborJob& job) override { search_.place(job.points, job.reach); }
  void search(const NeighborJob& job, tree::PairList& rows) override {
    search_.list(job.rule, job.listing, rows);
  }

 private:
  tree::Neighbors search_;
};

using enum SearchMethod;

constexpr std::array all{
    NeighborMaker{qcg, "quadtree cells grid", false, 120, 5, make_qcg},
    NeighborMaker{level_grids, "one grid a level", false, 90, 5, make_level_grids},
    NeighborMaker{uniform_grid, "one grid, vector tests", false, 90, 5, make_uniform_grid},
    NeighborMaker{linked_list, "linked list, half stencil", false, 30, 16, make_linked_list},
    NeighborMaker{leaf_quadtree, "quadtree, one particle a leaf", false, 200, 12,
                  make_leaf_quadtree},
    NeighborMaker{r_tree, "R-tree of Boost", false, 300, 12, make_r_tree},
    NeighborMaker{all_pairs, "all pairs", true, 10, 12, make_all_pairs}};

}  // namespace

std::unique_ptr<NeighborMethod> make_qcg() {
  return std::make_unique<Qcg>();
}

std::span<const NeighborMaker> makers() {
  return all;
}

const NeighborMaker& maker_of(SearchMethod method) {
  return all.at(static_cast<std::size_t>(method));
}

const NeighborMaker& maker_of(std::string_view name) {
  const auto found = std::ranges::find(all, name, &NeighborMaker::name);
  if (found != all.end()) return *found;
  throw std::invalid_argument("no neighbor method \"" + std::string(name) + "\"");
}

}  // namespace vortree::neighbors
