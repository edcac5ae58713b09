#include "fmm/leaves.hpp"

#include <algorithm>

#include "tree/lanes.hpp"

namespace vortree::fmm {
namespace {

constexpr std::size_t ahead = 48;  // places to ask memory for in advance
constexpr std::uint32_t crowd = 256;

bool any_core(const Blobs& blobs) {
  for (const double sigma : blobs.sigma) {
    if (sigma > 0.0) return true;
  }
  return false;
}

}  // namespace

Leaves::Leaves(const DeepTree& tree, const Blobs& blobs, const Units& units) {
  const auto cells = tree.cells();
  const auto childless = tree.childless();
  const auto order = tree.order();
  start.resize(childless.size() + 1);
  size.resize(childless.size());
  std::uint32_t end = 0;
  for (std::size_t leaf = 0; leaf < childless.size(); ++leaf) {
    start[leaf] = end;
    size[leaf] = cells[childless[leaf]].points.size();
    end += static_cast<std::uint32_t>(padded(size[leaf]));
  }
  start.back() = end;
  const bool cored = any_core(blobs);
  auto& [x, y, core] = points;
  for (auto* values : {&x, &y, &gamma}) values->resize(end);
  if (cored) core.resize(end);
#pragma omp parallel for schedule(static)
  for (std::size_t leaf = 0; leaf < childless.size(); ++leaf) {
    const tree::Range run = cells[childless[leaf]].points;
    std::uint32_t to = start[leaf];
    for (std::uint32_t j = run.first; j < run.last; ++j, ++to) {
      const std::uint32_t i = order[j], next = order[std::min(j + ahead, order.size() - 1)];
      __builtin_prefetch(&blobs.x[next]);
      __builtin_prefetch(&blobs.y[next]);
      __builtin_prefetch(&blobs.gamma[next]);
      x[to] = units.position(blobs.x[i]), y[to] = units.position(blobs.y[i]);
      gamma[to] = units.circulation(blobs.gamma[i]);
      if (cored) core[to] = units.squared_core(blobs.sigma[i]);
    }
    for (; to < start[leaf + 1]; ++to) {
      x[to] = x[to - 1], y[to] = y[to - 1], gamma[to] = 0.0;
      if (cored) core[to] = core[to - 1];
    }
  }
}

bool Leaves::in_one_place(std::uint32_t leaf) const {
  if (size[leaf] < crowd) return false;
  const std::uint32_t first = start[leaf], last = first + size[leaf];
  const auto all_equal = [&](const Reals& values) {
    return std::all_of(values.begin() + first, values.begin() + last,
                       [&](double value) { return value == values[first]; });
  };
  return all_equal(points.x) && all_equal(points.y);
}

}  // namespace vortree::fmm
