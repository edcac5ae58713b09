#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <vector>

#include "neighbors/exact_pairs.hpp"
#include "tree/base/parallel.hpp"
#include "tree/neighbors/pair_list.hpp"

namespace vortree::neighbors {

/// Rows from a search that takes one particle after the other.
///
/// n     particles
/// find  appends the neighbors of particle i: find(i, std::vector<std::int32_t>& row); called from
///       several threads
template <class Find>
void write_rows(std::size_t n, const Find& find, tree::PairList& rows) {
  constexpr std::size_t portion = 512;
  const std::size_t portions = (n + portion - 1) / portion;
  std::vector<std::vector<std::int32_t>> found(portions);
  rows.start.renew(n + 1);
  rows.start[0] = 0;
  std::atomic<std::int64_t> pairs = 0;
  tree::for_each_piece(portions, [&](std::size_t p) {
    for (std::size_t i = p * portion; i < std::min(n, (p + 1) * portion); ++i) {
      find(i, found[p]);
      rows.start[i + 1] = static_cast<std::int64_t>(found[p].size());
    }
    pairs += static_cast<std::int64_t>(found[p].size());
    if (pairs > rows.most) rows.refuse(pairs);
  });
  std::int64_t before = 0;
  for (std::size_t p = 0; p < portions; ++p) {
    for (std::size_t i = p * portion; i < std::min(n, (p + 1) * portion); ++i) {
      rows.start[i + 1] += before;
    }
    before += static_cast<std::int64_t>(found[p].size());
  }
  rows.make_room(before);
#pragma omp parallel for schedule(static)
  for (std::size_t p = 0; p < portions; ++p) {
    std::ranges::copy(found[p], rows.index.data() + rows.start[p * portion]);
  }
}

/// A method that takes one particle after the other: Method has
///
///   template <tree::PairRule rule>
///   void find(const NeighborJob& job, std::size_t i, std::vector<std::int32_t>& row) const
///
/// as write_rows() asks for.
template <class Method>
class RowByRow : public NeighborMethod {
 public:
  void search(const NeighborJob& job, tree::PairList& rows) final {
    const auto& method = static_cast<const Method&>(*this);
    with_rule(job.rule, [&]<tree::PairRule rule> {
      write_rows(
          job.points.size(),
          [&](std::size_t i, std::vector<std::int32_t>& row) {
            method.template find<rule>(job, i, row);
          },
          rows);
    });
  }
};

}  // namespace vortree::neighbors
