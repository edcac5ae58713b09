#include "fmm/geometry/leaves.hpp"

#include <algorithm>

#include "fmm/tuning.hpp"
#include "tree/base/parallel.hpp"
#include "tree/base/simd.hpp"

namespace vortree::fmm {
Leaves::Leaves(const DeepTree& tree, std::span<const Vortex> vortices, bool cored,
               std::size_t whole) {
  number(tree, cored ? lane_count : whole);
  Reals &x = points.x, &y = points.y, &core = points.core;
  for (auto* values : {&x, &y, &gamma}) values->resize(places());
  if (cored) core.resize(places());
  const auto cells = tree.cells();
  const auto childless = tree.childless();
  const auto order = tree.order();
  const auto fill = [&](std::uint32_t leaf) {
    const tree::Range run = cells[childless[leaf]].points;
    std::uint32_t to = start[leaf];
    for (std::uint32_t j = run.first; j < run.last; ++j, ++to) {
      __builtin_prefetch(&vortices[order[std::min(j + gathered_ahead, order.size() - 1)]]);
      const Vortex& vortex = vortices[order[j]];
      x[to] = vortex.x, y[to] = vortex.y, gamma[to] = vortex.gamma;
      if (cored) core[to] = vortex.core;
    }
    for (; to < start[leaf + 1]; ++to) {
      x[to] = x[to - 1], y[to] = y[to - 1], gamma[to] = 0.0;
      if (cored) core[to] = core[to - 1];
    }
  };
  tree::share_evenly(tree::all_of(childless.size()), order.size() > tree::records_worth_sharing,
                     fill);
}

void Leaves::number(const DeepTree& tree, std::size_t whole) {
  const auto cells = tree.cells();
  const auto childless = tree.childless();
  start.resize(childless.size() + 1);
  size.resize(childless.size());
  std::uint32_t end = 0;
  for (std::size_t leaf = 0; leaf < childless.size(); ++leaf) {
    start[leaf] = end;
    size[leaf] = cells[childless[leaf]].points.size();
    end += static_cast<std::uint32_t>(padded(size[leaf], whole));
  }
  start.back() = end;
}

bool Leaves::in_one_place(std::uint32_t leaf) const {
  if (size[leaf] < crowd_in_one_place) return false;
  const std::uint32_t first = start[leaf], last = first + size[leaf];
  const auto all_equal = [&](const Reals& values) {
    return std::all_of(values.begin() + first, values.begin() + last,
                       [&](double value) { return value == values[first]; });
  };
  return all_equal(points.x) && all_equal(points.y);
}

}  // namespace vortree::fmm
