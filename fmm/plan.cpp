#include "fmm/plan.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "fmm/multipole_kernel.hpp"

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

/// From here on single precision is exact enough: its errors are a tenth of the tolerance.
constexpr double coarse_tolerance = 1e-6;

bool coarse(const Options& options) {
  return options.order == 0 && options.tolerance >= coarse_tolerance;
}

Growth growth(const Options& options) {
  return {options.capacity, options.finest_level, options.builder};
}

Order choose_order(const Options& options) {
  return options.order > 0 ? Order::fixed(options.order)
                           : Order::for_tolerance(std::max(options.tolerance, least_tolerance));
}

bool any_core(const Arrangement& made) {
  return made.shapes.size() > 0 && made.shapes.core[0] > 0.0;
}

/// The tree, after the phase that follows it was told.
const tree::Quadtree& announced(const Plan::Phase& phase, std::string_view name,
                                const tree::Quadtree& tree) {
  if (phase) phase(name);
  return tree;
}

}  // namespace

Plan::Plan(const Blobs& blobs, const Options& options, const Phase& phase)
    : options_(resolve(options, blobs)),
      units_(Units::of(blobs)),
      order_(choose_order(options_)),
      blobs_(arrange({blobs.x, blobs.y, blobs.sigma}, units_, growth(options_))),
      gamma_(arrange_gamma(blobs_.tree, blobs.gamma, units_)),
      multipoles_(announced(phase, "upward", blobs_.tree), blobs_.shapes, blobs_.points, gamma_,
                  order_.most(), coarse(options_)) {}

Acceptance Plan::acceptance(bool cored) const {
  const double tolerance = std::max(options_.tolerance, least_tolerance);
  return {
      .order = order_, .reach2 = cored ? std::log(1.0 / tolerance) : 0.0, .cores = options_.cores};
}

void Plan::evaluate_at(const Arrangement& targets, bool cored, std::span<double> u,
                       std::span<double> v) const {
  evaluate({blobs_, multipoles_, gamma_}, targets, acceptance(cored), coarse(options_), u, v);
  units_.to_velocity(u);
  units_.to_velocity(v);
}

void Plan::velocity(std::span<double> u, std::span<double> v) const {
  check_result(size(), u, v);
  evaluate_at(blobs_, any_core(blobs_), u, v);
}

void Plan::velocity(const Targets& targets, std::span<double> u, std::span<double> v) const {
  fmm::check(targets);
  check_result(targets.size(), u, v);
  const Arrangement at = arrange(targets, units_, growth(options_));
  const bool cored = any_core(blobs_) || (options_.cores == Cores::mean && any_core(at));
  evaluate_at(at, cored, u, v);
}

void Plan::velocity_bare(tree::Points targets, std::span<double> u, std::span<double> v) const {
  const Targets bare{targets.x, targets.y, {}};
  fmm::check(bare);
  check_result(bare.size(), u, v);
  evaluate_at(arrange(bare, units_, growth(options_)), false, u, v);
}

Work Plan::work() const {
  return count_work({blobs_, multipoles_, gamma_}, blobs_, acceptance(any_core(blobs_)));
}

std::size_t Plan::bytes() const {
  const std::size_t per_point = 4 * sizeof(double) + sizeof(tree::Key) + sizeof(std::uint32_t);
  const std::size_t per_cell = sizeof(tree::Cell) + 6 * sizeof(double);
  return per_point * size() + per_cell * blobs_.shapes.size() + multipoles_.bytes();
}

}  // namespace vortree::fmm
