#include "fmm/direct.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "fmm/field/field.hpp"
#include "fmm/geometry/units.hpp"
#include "fmm/losses/expected.hpp"
#include "fmm/near/p2p_kernel.hpp"
#include "fmm/tuning.hpp"

namespace vortree::fmm {
namespace {

/// pack(S)   what a pair asks of the squared core of a source
template <class Pack>
std::vector<PackedSources> tiles(const Sources& sources, const Units& units, Pack pack) {
  std::vector<PackedSources> packed;
  for (std::size_t first = 0; first < sources.size(); first += sources_a_tile) {
    const std::size_t last = std::min(first + sources_a_tile, sources.size());
    PackedSources& tiled = packed.emplace_back();
    tiled.restart(last - first);
    for (std::size_t j = first; j < last; ++j) {
      const double core = sources.sigma.empty() ? 0.0 : units.squared_core(sources.sigma[j]);
      tiled.add(units.position(sources.x[j]), units.position(sources.y[j]),
                units.circulation(sources.gamma[j]), pack(core));
    }
    tiled.close();
  }
  return packed;
}

double total(const Sources& sources, const Units& units) {
  double all = 0.0;
  for (const double gamma : sources.gamma) all += units.circulation(gamma);
  return all;
}

struct TargetsInUnits {
  double x[targets_a_visit], y[targets_a_visit], core[targets_a_visit];
  std::size_t size;

  TargetsInUnits(const Targets& targets, std::size_t first, std::size_t most, const Units& units)
      : size(std::min(most, targets.size() - first)) {
    for (std::size_t i = 0; i < size; ++i) {
      x[i] = units.position(targets.x[first + i]);
      y[i] = units.position(targets.y[first + i]);
      core[i] = targets.sigma.empty() ? 0.0 : units.squared_core(targets.sigma[first + i]);
    }
  }
};

/// Targets of a visit: fewer where there are few, so that threads share them.
std::size_t a_visit(std::size_t targets) {
  return std::min(targets_a_visit, padded((targets + least_visits - 1) / least_visits));
}

template <class Pair>
void sum_all(const Sources& sources, const Targets& targets, std::span<double> u,
             std::span<double> v) {
  const Units units = Units::of(sources);
  const std::vector<PackedSources> tiled = tiles(sources, units, Pair::packed_core);
  std::ranges::fill(u, 0.0);
  std::ranges::fill(v, 0.0);
  const std::size_t n = targets.size(), most = a_visit(n);
  double found = 0.0;  // asked only for its order of magnitude
#pragma omp parallel for schedule(dynamic) reduction(+ : found)
  for (std::size_t first = 0; first < n; first += most) {
    const TargetsInUnits local(targets, first, most, units);
    const NearTargets some{local.x, local.y, local.core, &u[first], &v[first], local.size};
    for (const PackedSources& packed : tiled) p2p<Pair>(packed, some);
    for (const std::span<double> sums :
         {u.subspan(first, local.size), v.subspan(first, local.size)}) {
      found += sum_of_squares(sums);
      units.to_velocity(sums);
    }
  }
  units.check_range(found, n, 0);
  units.finish_far(total(sources, units), targets.x, targets.y, u, v);
}

bool bare(const Sources& sources, const Targets& targets, Cores cores) {
  const auto all_zero = [](std::span<const double> sigma) {
    return std::ranges::all_of(sigma, [](double value) { return value == 0.0; });
  };
  return all_zero(sources.sigma) && (cores == Cores::source || all_zero(targets.sigma));
}

/// What a field sums over all pairs, in Units.
template <class Field>
void sum_field(const Field& field, const Sources& sources, const Targets& targets, Cores cores,
               const Units& units, std::array<double*, 3> sums) {
  const auto tiled = tiles(sources, units, std::identity{});
  const bool without = bare(sources, targets, cores);
  const std::size_t n = targets.size(), most = a_visit(n);
  for (std::size_t s = 0; s < Field::count; ++s) std::fill_n(sums[s], n, 0.0);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t first = 0; first < n; first += most) {
    const TargetsInUnits local(targets, first, most, units);
    FieldTargets some{local.x, local.y, local.core, {}, local.size};
    for (std::size_t s = 0; s < Field::count; ++s) some.sums[s] = sums[s] + first;
    for (const PackedSources& packed : tiled) {
      if (without) {
        field.add_bare(packed, some);
      } else {
        field.add_cored(packed, CoreShares(cores), some);
      }
    }
  }
}

Units checked(const Sources& sources, const Targets& targets, bool log) {
  const Units units = check(sources);
  check(targets);
  for (const std::span<const double> sigma : {sources.sigma, targets.sigma}) {
    const std::string complaint = complain_of_cores(sigma, units, log);
    if (!complaint.empty()) throw std::invalid_argument(complaint);
  }
  return units;
}

}  // namespace

void velocity_direct(const Sources& sources, const Targets& targets, Cores cores,
                     std::span<double> u, std::span<double> v) {
  check(sources);
  check(targets);
  check_result(targets.size(), u, v);
  if (bare(sources, targets, cores)) {
    sum_all<BarePair>(sources, targets, u, v);
  } else if (cores == Cores::source) {
    sum_all<SourceCorePair<FineExp>>(sources, targets, u, v);
  } else {
    sum_all<MeanCorePair<FineExp>>(sources, targets, u, v);
  }
}

void gradient_direct(const Sources& sources, const Targets& targets, Cores cores,
                     std::span<double> ux, std::span<double> uy, std::span<double> vx) {
  const Units units = checked(sources, targets, false);
  check_result(targets.size(), "ux", ux);
  check_result(targets.size(), "uy", uy);
  check_result(targets.size(), "vx", vx);
  sum_field(FieldGradient{}, sources, targets, cores, units, {uy.data(), ux.data(), vx.data()});
  const std::size_t n = targets.size();
  units.check_range(sum_of_squares(ux) + sum_of_squares(uy) + sum_of_squares(vx), n, 1);
  finish_gradient(units, ux, uy, vx);
}

void stream_function_direct(const Sources& sources, const Targets& targets, Cores cores,
                            std::span<double> psi) {
  const Units units = checked(sources, targets, true);
  check_result(targets.size(), "psi", psi);
  sum_field(StreamFunction{log_unit(units), {}}, sources, targets, cores, units, {psi.data()});
  const double found = finish_stream_function(units, total(sources, units), targets, psi);
  units.check_range(found, psi.size(), -1);
}

}  // namespace vortree::fmm
