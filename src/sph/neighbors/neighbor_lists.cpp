#include "sph/neighbors/neighbor_lists.hpp"

#include "neighbors/sort_rows.hpp"

namespace vortree::sph {

void NeighborLists::renew(tree::Points points, std::span<const double> reach,
                          std::span<const std::int32_t> was, const NeighborSettings& settings,
                          double skin) {
  if (!search_ || settings.method != method_) {
    method_ = settings.method;
    search_ = neighbors::maker_of(method_).make();
  }
  if (skin == 0) return search(points, reach, settings.sorted, rows_);
  const auto all = [&](tree::Points at, std::span<const double> wide, tree::PairList& rows) {
    search(at, wide, true, rows);
  };
  kept_.renew(points, reach, was, skin, all, rows_);
}

void NeighborLists::search(tree::Points points, std::span<const double> reach, bool sorted,
                           tree::PairList& rows) {
  const neighbors::NeighborJob job{points, reach, tree::PairRule::mean, tree::Listing::both_ways};
  search_->build(job);
  search_->search(job, rows);
  if (sorted) neighbors::sort_rows(rows);
}

}  // namespace vortree::sph
