#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string_view>

#include "base/keys.hpp"
#include "tree/neighbors/pair_list.hpp"
#include "tree/neighbors/pair_rule.hpp"
#include "tree/order/points.hpp"

// Every way to find neighbors, for whoever lets a user choose.

namespace vortree::neighbors {

/// Best first:
///
///   qcg             tree/neighbors/neighbors.hpp
///   level-grids     a grid for each level of reach, counting sort; the tests and rows of qcg
///   uniform-grid    one such grid, cells as wide as the largest reach
///   linked-list     the paper's: the same cells, particles chained by index, 5-cell half stencil;
///                   serial
///   leaf-quadtree   one particle to a childless cell, searched from the root
///   r-tree          Boost.Geometry, packed; code that shares nothing with the others
///   all-pairs       every particle against every other, in doubles
enum class SearchMethod {
  qcg,
  level_grids,
  uniform_grid,
  linked_list,
  leaf_quadtree,
  r_tree,
  all_pairs
};

}  // namespace vortree::neighbors

namespace vortree {

template <>
inline constexpr std::array<std::string_view, 7> words_of<neighbors::SearchMethod>{
    "qcg", "level-grids", "uniform-grid", "linked-list", "leaf-quadtree", "r-tree", "all-pairs"};

}  // namespace vortree

namespace vortree::neighbors {

/// What is asked for: the neighbors of all particles among themselves.
struct NeighborJob {
  tree::Points points;
  std::span<const double> reach;
  tree::PairRule rule = tree::PairRule::max;
  tree::Listing listing = tree::Listing::both_ways;
};

/// A way to find neighbors. Kept from one step to the next: it uses its memory again.
class NeighborMethod {
 public:
  virtual ~NeighborMethod() = default;
  /// From unsorted arrays to whatever it searches in.
  virtual void build(const NeighborJob& job) = 0;
  /// From there to the finished rows.
  virtual void search(const NeighborJob& job, tree::PairList& rows) = 0;
};

/// One of the methods.
///
/// reads            what it is, in a few words
/// quadratic        its time grows like n^2
/// particle_bytes   memory that a particle takes, beside its input and its neighbors
/// pair_bytes       at most, that an entry of the list takes while it is sought and stored
struct NeighborMaker {
  SearchMethod method;
  std::string_view reads;
  bool quadratic;
  std::size_t particle_bytes, pair_bytes;
  std::unique_ptr<NeighborMethod> (*make)();

  [[nodiscard]] constexpr std::string_view name() const { return word(method); }
};

/// Every method, in the order of its enumeration.
[[nodiscard]] std::span<const NeighborMaker> makers();
[[nodiscard]] const NeighborMaker& maker_of(SearchMethod method);

/// The method of that name.
///
/// throws  std::invalid_argument if there is none
[[nodiscard]] const NeighborMaker& maker_of(std::string_view name);

std::unique_ptr<NeighborMethod> make_qcg();
std::unique_ptr<NeighborMethod> make_level_grids();
std::unique_ptr<NeighborMethod> make_uniform_grid();
std::unique_ptr<NeighborMethod> make_linked_list();
std::unique_ptr<NeighborMethod> make_leaf_quadtree();
std::unique_ptr<NeighborMethod> make_r_tree();
std::unique_ptr<NeighborMethod> make_all_pairs();

}  // namespace vortree::neighbors
