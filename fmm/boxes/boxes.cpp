#include "fmm/boxes/boxes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fmm/tuning.hpp"

namespace vortree::fmm {
namespace {

Options resolve(Options options, const Sources& sources) {
  if (options.capacity == 0)
    options.capacity = sources.sigma.empty() ? boxes_bare_capacity : boxes_cored_capacity;
  options.tolerance = std::max(options.tolerance, least_tolerance);
  return options;
}

TreeOptions grown(const Options& options) {
  return {options.capacity, options.finest_level, options.builder};
}

SeriesOrder choose_order(const Options& options) {
  return options.order > 0 ? SeriesOrder::fixed(options.order)
                           : SeriesOrder::for_tolerance(options.tolerance);
}

bool any_core(const Arrangement& made) {
  return made.shapes.size() > 0 && made.shapes.core[0] > 0.0;
}

void tell(const tree::Phase& phase, std::string_view name) {
  if (phase) phase(name);
}

/// The same, after the phase that follows was told.
template <class Value>
const Value& announced(const tree::Phase& phase, std::string_view name, const Value& value) {
  tell(phase, name);
  return value;
}

}  // namespace

Boxes::Boxes(const Sources& sources, const Units& units, const Options& options,
             const tree::Phase& phase)
    : options_(resolve(options, sources)),
      phase_(phase),
      units_(announced(phase, "tree", units)),
      order_(choose_order(options_)),
      sources_(arrange({sources.x, sources.y, sources.sigma}, units_, grown(options_))),
      gamma_(arrange_gamma(sources_.tree, sources.gamma, units_)),
      multipoles_(announced(phase, "upward", sources_.tree), sources_.shapes, sources_.points,
                  gamma_, order_.most(), coarse(options_)) {}

TreeOptions Boxes::growth() const {
  return grown(options_);
}

bool Boxes::cored(const Arrangement& targets) const {
  return any_core(sources_) || (options_.cores == Cores::mean && any_core(targets));
}

Acceptance Boxes::acceptance(bool cored) const {
  return {.order = order_,
          .reach2 = cored ? core_reach2(options_.tolerance) : 0.0,
          .cores = options_.cores,
          .lost2 = options_.tolerance * options_.tolerance};
}

Expected Boxes::evaluate_at(const Arrangement& targets, bool cored, std::span<double> u,
                            std::span<double> v) const {
  tell(phase_, "evaluate");
  const Expected expected =
      evaluate({sources_, multipoles_, gamma_}, targets, acceptance(cored), coarse(options_), u, v);
  units_.check_range(expected.found, u.size(), 0);
  units_.to_velocity(u);
  units_.to_velocity(v);
  return expected;
}

Expected Boxes::velocity(std::span<double> u, std::span<double> v) const {
  return evaluate_at(sources_, any_core(sources_), u, v);
}

Expected Boxes::velocity(const Targets& targets, std::span<double> u, std::span<double> v) const {
  const Arrangement at = arrange(targets, units_, growth());
  const Expected expected = evaluate_at(at, cored(at), u, v);
  units_.finish_far(std::accumulate(gamma_.begin(), gamma_.end(), 0.0), targets.x, targets.y, u, v);
  return expected;
}

Expected Boxes::velocity_bare(tree::Points targets, std::span<double> u,
                              std::span<double> v) const {
  const Expected expected =
      evaluate_at(arrange({targets.x, targets.y, {}}, units_, growth()), false, u, v);
  units_.finish_far(std::accumulate(gamma_.begin(), gamma_.end(), 0.0), targets.x, targets.y, u, v);
  return expected;
}

SourceColumns Boxes::sources() const {
  const auto order = sources_.tree.order();
  SourceColumns all;
  for (auto* column : {&all.x, &all.y, &all.gamma}) column->resize(order.size());
  const bool cored = any_core(sources_);
  if (cored) all.sigma.resize(order.size());
  for (std::size_t j = 0; j < order.size(); ++j) {
    all.x[order[j]] = sources_.points.x[j] / units_.per_length;
    all.y[order[j]] = sources_.points.y[j] / units_.per_length;
    all.gamma[order[j]] = gamma_[j] / units_.per_gamma;
    if (cored) all.sigma[order[j]] = std::sqrt(sources_.points.core[j]) / units_.per_length;
  }
  return all;
}

Work Boxes::work() const {
  Work work = count_work({sources_, multipoles_, gamma_}, sources_, acceptance(any_core(sources_)));
  work.cored_in_floats = coarse(options_);
  return work;
}

std::size_t Boxes::bytes() const {
  const std::size_t per_point =
      4 * sizeof(double) + sizeof(tree::MortonKey) + sizeof(std::uint32_t);
  const std::size_t per_cell = sizeof(tree::Cell) + 6 * sizeof(double);
  return per_point * sources_.points.size() + per_cell * sources_.shapes.size() +
         multipoles_.bytes();
}

}  // namespace vortree::fmm
