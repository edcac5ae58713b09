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

/// A blob in Units.
struct alignas(32) Record {
  double x, y, gamma, core;
};

/// The blobs in their input order, each in one place: to fetch it from afar costs one line of the
/// cache, not three or four.
Unwritten<Record> side_by_side(const Blobs& blobs, const Units& units, bool cored) {
  Unwritten<Record> records(blobs.size());
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < records.size(); ++i) {
    records[i] = {units.position(blobs.x[i]), units.position(blobs.y[i]),
                  units.circulation(blobs.gamma[i]),
                  cored ? units.squared_core(blobs.sigma[i]) : 0.0};
  }
  return records;
}

}  // namespace

Leaves::Leaves(const DeepTree& tree, const Blobs& blobs, const Units& units, std::size_t whole) {
  const auto cells = tree.cells();
  const auto childless = tree.childless();
  const auto order = tree.order();
  start.resize(childless.size() + 1);
  size.resize(childless.size());
  const bool cored = any_core(blobs);
  if (cored) whole = lane_count;
  std::uint32_t end = 0;
  for (std::size_t leaf = 0; leaf < childless.size(); ++leaf) {
    start[leaf] = end;
    size[leaf] = cells[childless[leaf]].points.size();
    end += static_cast<std::uint32_t>(padded(size[leaf], whole));
  }
  start.back() = end;
  auto& [x, y, core] = points;
  for (auto* values : {&x, &y, &gamma}) values->resize(end);
  if (cored) core.resize(end);
  const Unwritten<Record> records = side_by_side(blobs, units, cored);
#pragma omp parallel for schedule(static)
  for (std::size_t leaf = 0; leaf < childless.size(); ++leaf) {
    const tree::Range run = cells[childless[leaf]].points;
    std::uint32_t to = start[leaf];
    for (std::uint32_t j = run.first; j < run.last; ++j, ++to) {
      __builtin_prefetch(&records[order[std::min(j + ahead, order.size() - 1)]]);
      const Record& blob = records[order[j]];
      x[to] = blob.x, y[to] = blob.y, gamma[to] = blob.gamma;
      if (cored) core[to] = blob.core;
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
