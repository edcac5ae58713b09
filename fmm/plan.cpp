#include "fmm/plan.hpp"

#include <stdexcept>
#include <string>

#include "fmm/boxes.hpp"
#include "fmm/full.hpp"
#include "fmm/multipole_kernel.hpp"
#include "tree/told.hpp"

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

}  // namespace

Plan::Plan(const Blobs& blobs, const Options& options, const Phase& phase)
    : size_(blobs.size()), method_(options.method) {
  check(options);
  check(blobs);
  if (method_ == Method::fmm) {
    auto full = std::make_unique<Full>(blobs, options, phase);
    if (full->serves()) {
      sums_ = std::move(full);
      return;
    }
    method_ = Method::boxes;
  }
  sums_ = std::make_unique<Boxes>(blobs, options, phase);
}

void Plan::velocity(std::span<double> u, std::span<double> v) const {
  check_result(size(), u, v);
  sums_->velocity(u, v);
}

void Plan::velocity_and_gradient(std::span<double> u, std::span<double> v, std::span<double> ux,
                                 std::span<double> uy, std::span<double> vx) const {
  check_result(size(), u, v);
  check_result(size(), "ux", ux);
  check_result(size(), "uy", uy);
  check_result(size(), "vx", vx);
  sums_->velocity_and_gradient(u, v, ux, uy, vx);
}

void Plan::velocity(const Targets& targets, std::span<double> u, std::span<double> v) const {
  fmm::check(targets);
  check_result(targets.size(), u, v);
  sums_->velocity(targets, u, v);
}

void Plan::velocity_bare(tree::Points targets, std::span<double> u, std::span<double> v) const {
  fmm::check(Targets{targets.x, targets.y, {}});
  check_result(targets.size(), u, v);
  sums_->velocity_bare(targets, u, v);
}

void Plan::gradient(const Targets& targets, std::span<double> ux, std::span<double> uy,
                    std::span<double> vx) const {
  fmm::check(targets);
  check_result(targets.size(), "ux", ux);
  check_result(targets.size(), "uy", uy);
  check_result(targets.size(), "vx", vx);
  sums_->gradient(targets, ux, uy, vx);
}

void Plan::stream_function(const Targets& targets, std::span<double> psi) const {
  fmm::check(targets);
  check_result(targets.size(), "psi", psi);
  sums_->stream_function(targets, psi);
}

}  // namespace vortree::fmm
