#include "bench/rivals/neighbors/cell_lists.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "bench/sets/point_sets.hpp"

// Compiled without fused operations: both methods shall see the same distances.
namespace vortree::bench {
namespace {

using Lists = std::vector<std::vector<std::int32_t>>;

template <int dimensions>
struct CellListPoints {
  std::array<const double*, dimensions> x;
  std::size_t n;
  double r2;

  CellListPoints(const Coordinates& points, double reach) : n(points[0].size()), r2(reach * reach) {
    for (int d = 0; d < dimensions; ++d) x[d] = points[d].data();
  }

  void test(std::size_t i, std::size_t j, Lists& lists) const {
    double sum = 0;
    for (int d = 0; d < dimensions; ++d) sum += (x[d][i] - x[d][j]) * (x[d][i] - x[d][j]);
    if (!(sum < r2)) return;
    lists[i].push_back(static_cast<std::int32_t>(j));
    lists[j].push_back(static_cast<std::int32_t>(i));
  }
};

template <int dimensions>
Lists naive(const CellListPoints<dimensions>& p) {
  Lists lists(p.n);
  for (std::size_t i = 0; i < p.n; ++i) {
    for (std::size_t j = i + 1; j < p.n; ++j) p.test(i, j, lists);
  }
  return lists;
}

// A box of cells; the particles of each are one run of `order`.
template <int dimensions>
class CellLists {
 public:
  CellLists(const CellListPoints<dimensions>& p, double reach) {
    const double most = std::ceil(std::pow(static_cast<double>(p.n), 1.0 / dimensions));
    for (int d = 0; d < dimensions; ++d) {
      const auto [low, high] = std::minmax_element(p.x[d], p.x[d] + p.n);
      low_[d] = *low;
      side_[d] = std::max({reach * (1 + 1e-9), (*high - *low) * (1 + 1e-9) / most, 1e-300});
      size_[d] = static_cast<std::int64_t>((*high - *low) / side_[d]) + 1;
    }
    std::size_t cells = 1;
    for (const std::int64_t size : size_) cells *= static_cast<std::size_t>(size);
    first_.assign(cells + 1, 0);
    std::vector<std::size_t> cell(p.n);
    for (std::size_t i = 0; i < p.n; ++i) ++first_[(cell[i] = number(place(p, i))) + 1];
    for (std::size_t c = 0; c < cells; ++c) first_[c + 1] += first_[c];
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    order_.resize(p.n);
    for (std::size_t i = 0; i < p.n; ++i) order_[next[cell[i]]++] = static_cast<std::uint32_t>(i);
  }

  using Place = std::array<std::int64_t, dimensions>;

  [[nodiscard]] Place place(const CellListPoints<dimensions>& p, std::size_t i) const {
    Place at;
    for (int d = 0; d < dimensions; ++d) {
      at[d] = static_cast<std::int64_t>((p.x[d][i] - low_[d]) / side_[d]);
    }
    return at;
  }

  // Shows the particles of all cells around a place to visit.
  template <class Visit>
  void around(const Place& at, const Visit& visit) const {
    constexpr int cells = dimensions == 2 ? 9 : 27;
    for (int k = 0; k < cells; ++k) {
      Place there = at;
      bool inside = true;
      for (int d = 0, rest = k; d < dimensions; ++d, rest /= 3) {
        there[d] += rest % 3 - 1;
        inside = inside && there[d] >= 0 && there[d] < size_[d];
      }
      if (!inside) continue;
      const std::size_t c = number(there);
      for (std::size_t m = first_[c]; m < first_[c + 1]; ++m) visit(order_[m]);
    }
  }

  [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }

 private:
  [[nodiscard]] std::size_t number(const Place& at) const {
    std::int64_t cell = 0;
    for (int d = dimensions; d-- > 0;) cell = cell * size_[d] + at[d];
    return static_cast<std::size_t>(cell);
  }

  std::array<double, dimensions> low_, side_;
  Place size_;
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> order_;
};

template <int dimensions>
Lists by_cells(const CellListPoints<dimensions>& p, double reach) {
  Lists lists(p.n);
  if (p.n == 0) return lists;
  const CellLists<dimensions> cells(p, reach);
  for (const std::uint32_t i : cells.order()) {
    cells.around(cells.place(p, i), [&](std::uint32_t j) {
      if (j > i) p.test(i, j, lists);
    });
  }
  return lists;
}

}  // namespace

Lists neighbors_naive(const Coordinates& points, double reach) {
  return points.size() == 2 ? naive(CellListPoints<2>(points, reach))
                            : naive(CellListPoints<3>(points, reach));
}

Lists neighbors_by_cells(const Coordinates& points, double reach) {
  return points.size() == 2 ? by_cells(CellListPoints<2>(points, reach), reach)
                            : by_cells(CellListPoints<3>(points, reach), reach);
}

Coordinates random_coordinates(int dimensions, std::size_t n) {
  Uniform uniform(7);
  Coordinates points(static_cast<std::size_t>(dimensions), std::vector<double>(n));
  for (auto& x : points) {
    for (double& value : x) value = uniform();
  }
  return points;
}

}  // namespace vortree::bench
