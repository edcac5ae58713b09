#include "fmm/boxes.hpp"

#include <algorithm>
#include <cmath>

namespace vortree::fmm {
namespace {

/// Near sums with cores cost more a pair, but share more of their work among the targets of a leaf;
/// both optima are flat (half to twice the capacity costs less than a tenth).
constexpr std::uint32_t bare_capacity = 64, cored_capacity = 96;

Options resolve(Options options, const Blobs& blobs) {
  if (options.capacity == 0)
    options.capacity = blobs.sigma.empty() ? bare_capacity : cored_capacity;
  options.tolerance = std::max(options.tolerance, least_tolerance);
  return options;
}

Growth grown(const Options& options) {
  return {options.capacity, options.finest_level, options.builder};
}

Order choose_order(const Options& options) {
  return options.order > 0 ? Order::fixed(options.order) : Order::for_tolerance(options.tolerance);
}

bool any_core(const Arrangement& made) {
  return made.shapes.size() > 0 && made.shapes.core[0] > 0.0;
}

void tell(const Phase& phase, std::string_view name) {
  if (phase) phase(name);
}

/// The same, after the phase that follows was told.
template <class Value>
const Value& announced(const Phase& phase, std::string_view name, const Value& value) {
  tell(phase, name);
  return value;
}

}  // namespace

Boxes::Boxes(const Blobs& blobs, const Options& options, const Phase& phase)
    : options_(resolve(options, blobs)),
      phase_(phase),
      units_(Units::of(announced(phase, "tree", blobs))),
      order_(choose_order(options_)),
      blobs_(arrange({blobs.x, blobs.y, blobs.sigma}, units_, grown(options_))),
      gamma_(arrange_gamma(blobs_.tree, blobs.gamma, units_)),
      multipoles_(announced(phase, "upward", blobs_.tree), blobs_.shapes, blobs_.points, gamma_,
                  order_.most(), coarse(options_)) {}

Growth Boxes::growth() const {
  return grown(options_);
}

bool Boxes::cored(const Arrangement& targets) const {
  return any_core(blobs_) || (options_.cores == Cores::mean && any_core(targets));
}

Acceptance Boxes::acceptance(bool cored) const {
  return {.order = order_,
          .reach2 = cored ? core_reach2(options_.tolerance) : 0.0,
          .cores = options_.cores};
}

void Boxes::evaluate_at(const Arrangement& targets, bool cored, std::span<double> u,
                        std::span<double> v) const {
  tell(phase_, "evaluate");
  evaluate({blobs_, multipoles_, gamma_}, targets, acceptance(cored), coarse(options_), u, v);
  units_.to_velocity(u);
  units_.to_velocity(v);
}

void Boxes::velocity(std::span<double> u, std::span<double> v) const {
  evaluate_at(blobs_, any_core(blobs_), u, v);
}

void Boxes::velocity(const Targets& targets, std::span<double> u, std::span<double> v) const {
  const Arrangement at = arrange(targets, units_, growth());
  evaluate_at(at, cored(at), u, v);
}

void Boxes::velocity_bare(tree::Points targets, std::span<double> u, std::span<double> v) const {
  evaluate_at(arrange({targets.x, targets.y, {}}, units_, growth()), false, u, v);
}

Work Boxes::work() const {
  Work work = count_work({blobs_, multipoles_, gamma_}, blobs_, acceptance(any_core(blobs_)));
  work.cored_in_floats = coarse(options_);
  return work;
}

std::size_t Boxes::bytes() const {
  const std::size_t per_point = 4 * sizeof(double) + sizeof(tree::Key) + sizeof(std::uint32_t);
  const std::size_t per_cell = sizeof(tree::Cell) + 6 * sizeof(double);
  return per_point * blobs_.points.size() + per_cell * blobs_.shapes.size() + multipoles_.bytes();
}

}  // namespace vortree::fmm
