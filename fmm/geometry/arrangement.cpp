#include "fmm/geometry/arrangement.hpp"

#include <utility>

#include "fmm/tuning.hpp"
#include "tree/base/parallel.hpp"
#include "tree/build/build_forward.hpp"
#include "tree/build/build_reverse.hpp"

namespace vortree::fmm {
namespace {

/// to[j] = scaled(from[order[j]]), asking memory for what comes some steps later.
template <class Scale>
Reals gather(std::span<const std::uint32_t> order, std::span<const double> from, Scale scaled) {
  const std::size_t n = order.size();
  Reals to(n);
  tree::share_evenly(tree::all_of(n), n > tree::records_worth_sharing, [&](std::uint32_t j) {
    if (j + gathered_ahead < n) __builtin_prefetch(&from[order[j + gathered_ahead]]);
    to[j] = scaled(from[order[j]]);
  });
  return to;
}

}  // namespace

tree::Quadtree build(tree::MortonOrder order, const tree::SplitRule& rule, Builder builder) {
  return builder == Builder::reverse ? tree::build_reverse(std::move(order), rule)
                                     : tree::build_forward(std::move(order), rule);
}

Arrangement arrange(const Targets& points, const Units& units, const TreeOptions& growth) {
  const auto position = [units](double x) { return units.position(x); };
  const auto core = [units](double sigma) { return units.squared_core(sigma); };
  const tree::Points places{points.x, points.y};
  Arrangement made{build(tree::morton_order(places, tree::enclose(places), growth.finest_level),
                         tree::crowded(growth.capacity), growth.builder),
                   {},
                   {}};
  const auto order = made.tree.order();
  made.points = {
      gather(order, points.x, position), gather(order, points.y, position),
      points.sigma.empty() ? Reals(order.size(), 0.0) : gather(order, points.sigma, core)};
  made.shapes = CellShapes(made.tree, made.points);
  return made;
}

Reals arrange_gamma(const tree::Quadtree& tree, std::span<const double> gamma, const Units& units) {
  return gather(tree.order(), gamma, [units](double value) { return units.circulation(value); });
}

}  // namespace vortree::fmm
