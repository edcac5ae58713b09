#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "neighbors/methods.hpp"
#include "sph/neighbors/kept_list.hpp"
#include "sph/neighbors/settings.hpp"
#include "tree/neighbors/pair_list.hpp"
#include "tree/order/points.hpp"

namespace vortree::sph {

/// The neighbors of particles that are nearer than the mean of their reaches, step after step, as a
/// scene asks for them.
class NeighborLists {
 public:
  /// was   as of KeptList
  /// skin  in reaches
  void renew(tree::Points points, std::span<const double> reach, std::span<const std::int32_t> was,
             const NeighborSettings& settings, double skin);

  [[nodiscard]] std::span<const std::int32_t> row(std::size_t i) const { return rows_.row(i); }
  [[nodiscard]] const tree::PairList& rows() const { return rows_; }
  /// To take pairs out of until the next search.
  [[nodiscard]] tree::PairList& rows() { return rows_; }

 private:
  void search(tree::Points points, std::span<const double> reach, bool sorted,
              tree::PairList& rows);

  neighbors::SearchMethod method_{};
  std::unique_ptr<neighbors::NeighborMethod> search_;
  KeptList kept_;
  tree::PairList rows_;
};

}  // namespace vortree::sph
