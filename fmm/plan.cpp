#include "fmm/plan.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "fmm/multipole_kernel.hpp"
#include "tree/build_forward.hpp"
#include "tree/build_reverse.hpp"
#include "tree/split_rule.hpp"

namespace vortree::fmm {
namespace {

constexpr double least_tolerance = 1e-16;  // nothing is gained by asking for less

void check(const Options& options) {
  if (!(options.tolerance > 0.0 && options.tolerance < 1.0)) {
    throw std::invalid_argument("tolerance is " + std::to_string(options.tolerance) +
                                "; it must be in (0, 1)");
  }
  if (options.order < 0 || options.order > most_terms) {
    throw std::invalid_argument("order is " + std::to_string(options.order) +
                                "; it must be in 0 .. " + std::to_string(most_terms));
  }
  if (options.finest_level < 0 || options.finest_level > tree::max_level) {
    throw std::invalid_argument("finest_level is " + std::to_string(options.finest_level) +
                                "; it must be in 0 .. " + std::to_string(tree::max_level));
  }
}

/// Near sums with cores cost more a pair, but share more of their work among the targets of a leaf;
/// both optima are flat (half to twice the capacity costs less than a tenth).
constexpr std::uint32_t bare_capacity = 64, cored_capacity = 96;

Options resolve(Options options, const Blobs& blobs) {
  check(options);
  check(blobs);
  if (options.capacity == 0)
    options.capacity = blobs.sigma.empty() ? bare_capacity : cored_capacity;
  return options;
}

tree::Quadtree build(tree::Points points, const Options& options) {
  const tree::Domain domain = tree::enclose(points);
  tree::MortonOrder order = tree::morton_order(points, domain, options.finest_level);
  const tree::SplitRule rule = tree::crowded(options.capacity);
  return options.builder == Builder::reverse ? tree::build_reverse(std::move(order), rule)
                                             : tree::build_forward(std::move(order), rule);
}

SortedPoints sorted(const tree::Quadtree& tree, const Targets& points, const Units& units) {
  const auto order = tree.order();
  SortedPoints result{Reals(order.size()), Reals(order.size()), Reals(order.size())};
  for (std::size_t j = 0; j < order.size(); ++j) {
    result.x[j] = units.position(points.x[order[j]]);
    result.y[j] = units.position(points.y[order[j]]);
    result.core[j] = points.sigma.empty() ? 0.0 : units.squared_core(points.sigma[order[j]]);
  }
  return result;
}

Reals sorted(const tree::Quadtree& tree, std::span<const double> gamma, const Units& units) {
  const auto order = tree.order();
  Reals result(order.size());
  for (std::size_t j = 0; j < order.size(); ++j) result[j] = units.circulation(gamma[order[j]]);
  return result;
}

Order choose_order(const Options& options) {
  return options.order > 0 ? Order::fixed(options.order)
                           : Order::for_tolerance(std::max(options.tolerance, least_tolerance));
}

bool any_core(const SortedPoints& points) {
  return std::ranges::any_of(points.core, [](double core) { return core > 0.0; });
}

}  // namespace

Plan::Plan(const Blobs& blobs, const Options& options)
    : options_(resolve(options, blobs)),
      units_(Units::of(blobs)),
      tree_(build({blobs.x, blobs.y}, options_)),
      points_(sorted(tree_, Targets{blobs.x, blobs.y, blobs.sigma}, units_)),
      gamma_(sorted(tree_, blobs.gamma, units_)),
      shapes_(tree_, points_) {
  order_ = choose_order(options_);
  cored_ = any_core(points_);
  multipoles_ = Multipoles(tree_, shapes_, points_, gamma_, order_.most());
}

Acceptance Plan::acceptance(bool cored) const {
  const double tolerance = std::max(options_.tolerance, least_tolerance);
  return {
      .order = order_, .reach2 = cored ? std::log(1.0 / tolerance) : 0.0, .cores = options_.cores};
}

SourceSide Plan::sources() const {
  return {tree_, shapes_, multipoles_, points_, gamma_};
}

void Plan::velocity(std::span<double> u, std::span<double> v) const {
  check_result(size(), u, v);
  evaluate(sources(), {tree_, shapes_, points_}, acceptance(cored_), options_.tolerance, u, v);
  units_.to_velocity(u);
  units_.to_velocity(v);
}

void Plan::velocity_at(const Targets& targets, bool bare, std::span<double> u,
                       std::span<double> v) const {
  fmm::check(targets);
  check_result(targets.size(), u, v);
  const tree::Quadtree tree = build({targets.x, targets.y}, options_);
  const SortedPoints points = sorted(tree, targets, units_);
  const CellShapes shapes(tree, points);
  const bool cored = cored_ || (options_.cores == Cores::mean && any_core(points));
  evaluate(sources(), {tree, shapes, points}, acceptance(cored && !bare), options_.tolerance, u, v);
  units_.to_velocity(u);
  units_.to_velocity(v);
}

void Plan::velocity(const Targets& targets, std::span<double> u, std::span<double> v) const {
  velocity_at(targets, false, u, v);
}

void Plan::velocity_bare(tree::Points targets, std::span<double> u, std::span<double> v) const {
  velocity_at({targets.x, targets.y, {}}, true, u, v);
}

Work Plan::work() const {
  return count_work(sources(), {tree_, shapes_, points_}, acceptance(cored_));
}

std::size_t Plan::bytes() const {
  const std::size_t per_point = 4 * sizeof(double) + sizeof(tree::Key) + sizeof(std::uint32_t);
  const std::size_t per_cell = sizeof(tree::Cell) + 6 * sizeof(double);
  return per_point * size() + per_cell * shapes_.size() + multipoles_.bytes();
}

}  // namespace vortree::fmm
