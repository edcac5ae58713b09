#include "fmm/losses/far_errors.hpp"

#include <cmath>
#include <numbers>
#include <type_traits>

#include "fmm/losses/near_errors.hpp"
#include "tree/base/parallel.hpp"

namespace vortree::fmm {
namespace {

constexpr double levels = 8, rings = 20 * std::numbers::pi;  // lattice_order.hpp
constexpr double places = 27;                                // of V
constexpr double nearest = 5;         // what a place of V at the least distance loses over the mean
constexpr double mean_distance2 = 6;  // of V

Charge operator+(const Charge& a, const Charge& b) {
  return {a.effective + b.effective, a.squares + b.squares};
}

template <class Number>
Unwritten<Charge> sum_families(const Stage& stage, const FarField<Number>& far) {
  const auto cells = stage.tree.cells();
  Unwritten<Charge> families(cells.size());
  const bool shared = cells.size() > tree::cells_worth_sharing;
  tree::share_evenly(tree::all_of(cells.size()), shared, [&](std::uint32_t c) {
    for (std::uint32_t k = cells[c].children.first; k < cells[c].children.last; ++k) {
      families[c] = families[c] + far.charges()[k];
    }
  });
  return families;
}

}  // namespace

template <class Number>
FarErrors::FarErrors(const Stage& stage, const FarField<Number>& far, const LatticeOrder& order,
                     int derivative)
    : series_(std::pow(expected_error(order), 2) * rings / levels / places),
      rounding_(std::is_same_v<Number, float> ? float_rounding2 : 0.0),
      derivative_(derivative),
      terms_(order.most) {
  const auto cells = stage.tree.cells();
  const InteractionLists& lists = stage.lists;
  const Unwritten<Charge> families = sum_families(stage, far);
  errors_.resize(cells.size());
  for (int level = 0; level < stage.tree.depth(); ++level) {
    const tree::Range range = stage.tree.level(level);
    tree::share_in_turn(range, 64, range.size() > tree::series_worth_sharing, [&](std::uint32_t c) {
      if (cells[c].childless()) return;
      Charge met;
      for (int k = 0; k < 9; ++k) {
        if (k != InteractionLists::middle && lists.open(c, k)) {
          met = met + families[static_cast<std::uint32_t>(lists.neighbors(c)[k])];
        }
      }
      const double side = stage.tree.frame(cells[c].children.first).side;
      Lost family = errors_[c];
      family += of_one(met, side);
      for (std::uint32_t k = cells[c].children.first; k < cells[c].children.last; ++k) {
        errors_[k] = family;
        for (const std::uint32_t b : lists.x(k)) {
          errors_[k] += of_multipole(far.charges()[b], side, side_away2 * side * side);
        }
      }
    });
  }
}

Lost FarErrors::of_one(const Charge& charge, double side) const {
  const double per_area = 1 / (side * side);
  double series = series_ * charge.effective * per_area;
  double rounding = rounding_ / mean_distance2 * charge.squares * per_area;
  const double terms = terms_;
  if (derivative_ > 0) series *= terms * terms * per_area, rounding *= per_area;
  if (derivative_ < 0) {
    const double logarithm = std::log(side);
    series *= 4 / (terms * terms * per_area);  // 2 Re Phi is summed
    rounding *= 4 * (1 + logarithm * logarithm) / per_area * mean_distance2;
  }
  return {series, rounding};
}

Lost FarErrors::of_multipole(const Charge& charge, double side, double distance2) const {
  Lost error = of_one(charge, side);
  const double nearer = side_away2 * side * side / distance2, squared = nearer * nearer;
  error.series *= nearest * squared * squared;
  if (derivative_ >= 0) error.rounding *= mean_distance2 * side * side / distance2;
  return error;
}

template FarErrors::FarErrors(const Stage&, const FarField<double>&, const LatticeOrder&, int);
template FarErrors::FarErrors(const Stage&, const FarField<float>&, const LatticeOrder&, int);

}  // namespace vortree::fmm
