#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "bench/rivals/trees/tree_rivals.hpp"
#include "tree/base/memory.hpp"
#include "tree/base/parallel.hpp"
#include "tree/build/assembly.hpp"
#include "tree/order/encode_kernel.hpp"
#include "tree/order/run_sort.hpp"

namespace vortree::bench {
namespace {

using tree::Cell;
using tree::MortonKey;
using tree::Range;
using tree::Record;
using Records = Unwritten<Record>;

Records encoded(tree::Points points, const tree::Domain& domain) {
  constexpr std::size_t some = 1024;
  const tree::kernel::DomainAxis x{domain.x0, domain.x0 + domain.side, 0x1p31 / domain.side};
  const tree::kernel::DomainAxis y{domain.y0, domain.y0 + domain.side, 0x1p31 / domain.side};
  Records records(points.size());
#pragma omp parallel for schedule(static) if (points.size() > tree::worth_sharing)
  for (std::size_t first = 0; first < points.size(); first += some) {
    std::array<MortonKey, some> keys;
    const std::size_t n = std::min(some, points.size() - first);
    (void)tree::kernel::codes(&points.x[first], &points.y[first], n, x, y, ~MortonKey{0},
                              keys.data());
    for (std::size_t i = 0; i < n; ++i) {
      records[first + i] = {keys[i], static_cast<std::uint32_t>(first + i)};
    }
  }
  return records;
}

// Moves the particles of a cell to its quarters, by way of `spare`; returns where those end.
std::array<std::uint32_t, 4> quarter(Records& records, Records& spare, const Cell& cell) {
  const int low = 2 * (tree::max_level - cell.level - 1);
  std::array<std::uint32_t, 4> end{};
  for (std::uint32_t j = cell.points.first; j < cell.points.last; ++j) {
    ++end[records[j].key >> low & 3];
  }
  std::uint32_t next = cell.points.first;
  for (std::uint32_t& count : end) next += std::exchange(count, next);
  for (std::uint32_t j = cell.points.first; j < cell.points.last; ++j) {
    spare[end[records[j].key >> low & 3]++] = records[j];
  }
  std::copy(spare.begin() + cell.points.first, spare.begin() + cell.points.last,
            records.begin() + cell.points.first);
  return end;
}

class Partition {
 public:
  Partition(Records& records, std::uint32_t n_ctrl)
      : records_(records), spare_(records.size()), n_ctrl_(n_ctrl) {}

  tree::Assembly run() {
    const auto n = static_cast<std::uint32_t>(records_.size());
    if (n > 0) cells_.push_back({0, 0, -1, {}, {0, n}});
    std::vector<std::uint32_t> level_first{0};
    for (std::uint32_t first = 0; first < cells_.size(); first = level_first.back()) {
      const Range level{first, static_cast<std::uint32_t>(cells_.size())};
      level_first.push_back(level.last);
      split(level);
    }
    auto childless = tree::rank_childless(cells_);
    return {std::move(cells_), std::move(level_first), std::move(childless)};
  }

 private:
  void split(Range level) {
    std::vector<std::uint32_t> crowded;
    if (cells_[level.first].level < tree::max_level) {
      for (std::uint32_t c = level.first; c < level.last; ++c) {
        if (cells_[c].points.size() > n_ctrl_) crowded.push_back(c);
      }
    }
    std::vector<std::array<std::uint32_t, 4>> ends(crowded.size());
#pragma omp parallel for schedule(dynamic, 16) if (records_.size() > tree::worth_sharing)
    for (std::size_t k = 0; k < crowded.size(); ++k) {
      ends[k] = quarter(records_, spare_, cells_[crowded[k]]);
    }
    for (std::size_t k = 0; k < crowded.size(); ++k) add_children(crowded[k], ends[k]);
  }

  void add_children(std::uint32_t parent, const std::array<std::uint32_t, 4>& ends) {
    std::uint32_t first = cells_[parent].points.first;
    const auto eldest = static_cast<std::uint32_t>(cells_.size());
    for (MortonKey q = 0; q < 4; first = ends[q++]) {
      if (first == ends[q]) continue;
      cells_.push_back({cells_[parent].key * 4 + q,
                        cells_[parent].level + 1,
                        static_cast<std::int32_t>(parent),
                        {},
                        {first, ends[q]}});
    }
    cells_[parent].children = {eldest, static_cast<std::uint32_t>(cells_.size())};
  }

  Records& records_;
  Records spare_;
  std::uint32_t n_ctrl_;
  std::vector<Cell> cells_;
};

tree::MortonOrder finished(const tree::Domain& domain, Records& records,
                           const tree::Assembly& grown) {
  const std::size_t n = records.size();
  tree::MortonOrder order{domain, tree::max_level, Unwritten<MortonKey>(n),
                          Unwritten<std::uint32_t>(n)};
#pragma omp parallel for schedule(static) if (n > tree::worth_sharing)
  for (const std::uint32_t c : grown.childless) {
    const Range run = grown.cells[c].points;
    std::sort(records.begin() + run.first, records.begin() + run.last,
              [](const Record& a, const Record& b) {
                return a.key < b.key || (a.key == b.key && a.index < b.index);
              });
    for (std::uint32_t j = run.first; j < run.last; ++j) {
      order.keys[j] = records[j].key;
      order.index[j] = records[j].index;
    }
  }
  return order;
}

}  // namespace

tree::Quadtree forward_by_partition(tree::Points points, const tree::Domain& domain,
                                    std::uint32_t n_ctrl, const tree::Phase& phase) {
  phase("encode");
  Records records = encoded(points, domain);
  phase("build");
  tree::Assembly grown = Partition(records, n_ctrl).run();
  phase("finish");
  tree::MortonOrder order = finished(domain, records, grown);
  return std::move(grown).over(std::move(order));
}

}  // namespace vortree::bench
