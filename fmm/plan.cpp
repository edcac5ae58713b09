#include "fmm/plan.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "fmm/adaptive/adaptive.hpp"
#include "fmm/boxes/boxes.hpp"
#include "fmm/geometry/bounds.hpp"
#include "fmm/pairs/pair_sums.hpp"
#include "fmm/series/multipole_kernel.hpp"
#include "tree/base/told.hpp"

namespace vortree::fmm {
namespace {

void check(const Options& options) {
  if (!(options.tolerance > 0.0 && options.tolerance < 1.0)) {
    throw std::invalid_argument("tolerance is " + tree::told(options.tolerance) +
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

/// Promises are kept with so much in hand for what is expected (Expected).
constexpr double in_hand = 1.5;
constexpr int most_rounds = 4;
constexpr double doubles_from = 5e-7;  // tolerances below coarse()

/// The tolerance to sum with in place of options.tolerance, so that `asked` is kept.
double finer_tolerance(const Options& options, double asked, const Expected& expected) {
  const double allowed = std::pow(asked / in_hand, 2) * expected.found;
  double finer = options.tolerance;
  if (expected.lost.all() <= allowed) return finer;
  if (2 * expected.lost.series > allowed) {
    finer *= std::sqrt(allowed / (4 * expected.lost.series));
  }
  if (2 * expected.lost.rounding > allowed && coarse(options)) {
    finer = std::min(finer, doubles_from);
  }
  return std::max(finer, least_tolerance);
}

void refuse_unfit(const std::string& complaint) {
  if (!complaint.empty()) throw std::invalid_argument(complaint);
}

/// method   what was asked for; overwritten by what is taken
std::unique_ptr<const Evaluator> make_sums(const Sources& sources, const SourceBounds& bounds,
                                           const Options& options, const tree::Phase& phase,
                                           SumMethod& method) {
  if (method == SumMethod::direct) return std::make_unique<PairSums>(sources, options, phase);
  if (method == SumMethod::fmm) {
    auto full = std::make_unique<Adaptive>(sources, bounds, options, phase);
    if (full->serves()) return full;
    method = SumMethod::boxes;
  }
  return std::make_unique<Boxes>(sources, Units::of(bounds), options, phase);
}

}  // namespace

Plan::Plan(const Sources& sources, const Options& options, const tree::Phase& phase)
    : size_(sources.size()), options_(options), phase_(phase), method_(options.method) {
  check(options);
  const SourceBounds bounds = SourceBounds::of(sources);
  units_ = check(sources, bounds);
  cores_unfit_ = {complain_of_cores(sources.sigma, bounds.sigma, units_, false),
                  complain_of_cores(sources.sigma, bounds.sigma, units_, true)};
  sums_ = make_sums(sources, bounds, options, phase, method_);
}

/// Sums, and where that cancels so far that the tolerance is not kept, sums again with more terms
/// and digits.
template <class Sum>
void Plan::settle(Sum sum) const {
  Expected expected = sum(*sums_);
  Options options = options_;
  for (int round = 0; options.order == 0 && round < most_rounds; ++round) {
    const double finer = finer_tolerance(options, options_.tolerance, expected);
    if (!(finer < options.tolerance)) break;
    options.tolerance = finer;
    const SourceColumns columns = sums_->sources();
    const Sources sources = columns.view();
    SumMethod method = options_.method;
    expected = sum(*make_sums(sources, SourceBounds::of(sources), options, phase_, method));
  }
}

void Plan::velocity(std::span<double> u, std::span<double> v) const {
  check_result(size(), u, v);
  settle([&](const Evaluator& sums) { return sums.velocity(u, v); });
}

void Plan::velocity_and_gradient(std::span<double> u, std::span<double> v, std::span<double> ux,
                                 std::span<double> uy, std::span<double> vx) const {
  check_result(size(), u, v);
  check_result(size(), "ux", ux);
  check_result(size(), "uy", uy);
  check_result(size(), "vx", vx);
  refuse_unfit(cores_unfit_[0]);
  settle([&](const Evaluator& sums) { return sums.velocity_and_gradient(u, v, ux, uy, vx); });
}

void Plan::velocity(const Targets& targets, std::span<double> u, std::span<double> v) const {
  fmm::check(targets);
  check_result(targets.size(), u, v);
  settle([&](const Evaluator& sums) { return sums.velocity(targets, u, v); });
}

void Plan::velocity_bare(tree::Points targets, std::span<double> u, std::span<double> v) const {
  fmm::check(Targets{targets.x, targets.y, {}});
  check_result(targets.size(), u, v);
  settle([&](const Evaluator& sums) { return sums.velocity_bare(targets, u, v); });
}

void Plan::gradient(const Targets& targets, std::span<double> ux, std::span<double> uy,
                    std::span<double> vx) const {
  fmm::check(targets);
  check_result(targets.size(), "ux", ux);
  check_result(targets.size(), "uy", uy);
  check_result(targets.size(), "vx", vx);
  refuse_unfit(cores_unfit_[0]);
  refuse_unfit(complain_of_cores(targets.sigma, units_, false));
  settle([&](const Evaluator& sums) { return sums.gradient(targets, ux, uy, vx); });
}

void Plan::stream_function(const Targets& targets, std::span<double> psi) const {
  fmm::check(targets);
  check_result(targets.size(), "psi", psi);
  refuse_unfit(cores_unfit_[1]);
  refuse_unfit(complain_of_cores(targets.sigma, units_, true));
  settle([&](const Evaluator& sums) { return sums.stream_function(targets, psi); });
}

}  // namespace vortree::fmm
