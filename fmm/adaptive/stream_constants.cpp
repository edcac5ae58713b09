#include "fmm/adaptive/stream_constants.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "fmm/field/field_kernel.hpp"
#include "tree/base/parallel.hpp"

namespace vortree::fmm {
namespace {

constexpr int children = 4, vectors = static_cast<int>(padded(children)) / lane_count;

/// The centres of the children of a cell in some frame: (q % 2 - x, q / 2 - y) times a length.
void place_children(double x, double y, double length, Complexes (&t)[vectors]) {
  for (int i = 0; i < vectors * lane_count; ++i) {
    const int q = std::min(i, children - 1);
    t[i / lane_count].re[i % lane_count] = (q % 2 - x) * length;
    t[i / lane_count].im[i % lane_count] = (q / 2 - y) * length;
  }
}

double at_child(const Lanes (&values)[vectors], int q) {
  return values[q / lane_count][q % lane_count];
}

using ChildSums = std::array<double, children>;

/// The children of c meet the child in quadrant r of c's neighbor k, where they do not touch it.
template <class Number>
void add_v(const SeriesView<Number>& multipole, int k, int r, double log_side2, ChildSums& sums) {
  const int x = 2 * (k % 3 - 1) + r % 2, y = 2 * (k / 3 - 1) + r / 2;
  Complexes t[vectors];
  Lanes values[vectors];
  place_children(x, y, 1.0, t);
  log_of_multipole<vectors>(static_cast<double>(multipole.re[0]), log_side2,
                            multipole_integral(multipole), t, values);
  for (int q = 0; q < children; ++q) {
    if (std::max(std::abs(q % 2 - x), std::abs(q / 2 - y)) > 1) sums[q] += at_child(values, q);
  }
}

double sum_x(const Stage& stage, std::uint32_t c) {
  const CellFrame& at = stage.tree.frame(c);
  const SortedPoints& points = stage.leaves.points;
  Lanes total{};
  for (const std::uint32_t b : stage.lists.x(c)) {
    const tree::Range places = stage.leaves.places(stage.lists.leaves(b));
    for (std::uint32_t j = places.first; j < places.last; j += lane_count) {
      const Lanes dx = (load(&points.x[j]) - at.x) - at.x_rest;
      const Lanes dy = (load(&points.y[j]) - at.y) - at.y_rest;
      total += load(&stage.leaves.gamma[j]) * logarithm(dx * dx + dy * dy);
    }
  }
  return sum(total);
}

template <class Number>
void add_family(const Stage& stage, const FarField<Number>& far, std::uint32_t parent,
                std::vector<double>& centres) {
  const InteractionLists& lists = stage.lists;
  const double log_side2 = 2 * std::log(stage.tree.frame(parent).side / 2);
  Complexes t[vectors];
  Lanes values[vectors];
  place_children(0.5, 0.5, 0.5, t);
  log_of_local<vectors>(local_integral(far.view_local(parent)), t, values);
  ChildSums sums;
  for (int q = 0; q < children; ++q) sums[q] = centres[parent] + at_child(values, q);
  for (int k = 0; k < 9; ++k) {
    if (k == InteractionLists::middle || !lists.open(parent, k)) continue;
    const std::int32_t neighbor = lists.neighbors(parent)[k];
    for (int r = 0; r < children; ++r) {
      const std::int32_t child = lists.children(neighbor)[r];
      if (child != nobody) add_v(far.view_multipole(child), k, r, log_side2, sums);
    }
  }
  for (int q = 0; q < children; ++q) {
    const std::int32_t child = lists.children(parent)[q];
    if (child == nobody) continue;
    centres[child] = sums[q] + sum_x(stage, static_cast<std::uint32_t>(child));
  }
}

}  // namespace

template <class Number>
std::vector<double> stream_constants(const Stage& stage, const FarField<Number>& far) {
  const auto cells = stage.tree.cells();
  std::vector<double> centres(cells.size(), 0.0);
  for (int level = 0; level < stage.tree.depth(); ++level) {
    const tree::Range range = stage.tree.level(level);
    tree::share_in_turn(range, 64, range.size() > tree::series_worth_sharing, [&](std::uint32_t c) {
      if (!cells[c].childless()) add_family(stage, far, c, centres);
    });
  }
  return centres;
}

template std::vector<double> stream_constants(const Stage&, const FarField<double>&);
template std::vector<double> stream_constants(const Stage&, const FarField<float>&);

}  // namespace vortree::fmm
