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
std::vector<PackedSources> tiles(const Blobs& blobs, const Units& units, Pack pack) {
  std::vector<PackedSources> packed;
  for (std::size_t first = 0; first < blobs.size(); first += sources_a_tile) {
    const std::size_t last = std::min(first + sources_a_tile, blobs.size());
    PackedSources& sources = packed.emplace_back();
    sources.restart(last - first);
    for (std::size_t j = first; j < last; ++j) {
      const double core = blobs.sigma.empty() ? 0.0 : units.squared_core(blobs.sigma[j]);
      sources.add(units.position(blobs.x[j]), units.position(blobs.y[j]),
                  units.circulation(blobs.gamma[j]), pack(core));
    }
    sources.close();
  }
  return packed;
}

double total(const Blobs& blobs, const Units& units) {
  double all = 0.0;
  for (const double gamma : blobs.gamma) all += units.circulation(gamma);
  return all;
}

struct TargetsInUnits {
  double x[targets_a_visit], y[targets_a_visit], core[targets_a_visit];
  std::size_t size;

  TargetsInUnits(const Targets& targets, std::size_t first, const Units& units)
      : size(std::min(targets_a_visit, targets.size() - first)) {
    for (std::size_t i = 0; i < size; ++i) {
      x[i] = units.position(targets.x[first + i]);
      y[i] = units.position(targets.y[first + i]);
      core[i] = targets.sigma.empty() ? 0.0 : units.squared_core(targets.sigma[first + i]);
    }
  }
};

template <class Pair>
void sum_all(const Blobs& blobs, const Targets& targets, std::span<double> u, std::span<double> v) {
  const Units units = Units::of(blobs);
  const std::vector<PackedSources> sources = tiles(blobs, units, Pair::packed_core);
  std::ranges::fill(u, 0.0);
  std::ranges::fill(v, 0.0);
  const std::size_t n = targets.size();
  double found = 0.0;  // asked only for its order of magnitude
#pragma omp parallel for schedule(dynamic) reduction(+ : found)
  for (std::size_t first = 0; first < n; first += targets_a_visit) {
    const TargetsInUnits local(targets, first, units);
    const NearTargets some{local.x, local.y, local.core, &u[first], &v[first], local.size};
    for (const PackedSources& packed : sources) p2p<Pair>(packed, some);
    for (const std::span<double> sums :
         {u.subspan(first, local.size), v.subspan(first, local.size)}) {
      found += sum_of_squares(sums);
      units.to_velocity(sums);
    }
  }
  units.check_range(found, n, 0);
  units.finish_far(total(blobs, units), targets.x, targets.y, u, v);
}

bool bare(const Blobs& blobs, const Targets& targets, Cores cores) {
  const auto all_zero = [](std::span<const double> sigma) {
    return std::ranges::all_of(sigma, [](double value) { return value == 0.0; });
  };
  return all_zero(blobs.sigma) && (cores == Cores::source || all_zero(targets.sigma));
}

/// What a field sums over all pairs, in Units.
template <class Field>
void sum_field(const Field& field, const Blobs& blobs, const Targets& targets, Cores cores,
               const Units& units, std::array<double*, 3> sums) {
  const auto sources = tiles(blobs, units, std::identity{});
  const bool without = bare(blobs, targets, cores);
  const std::size_t n = targets.size();
  for (std::size_t s = 0; s < Field::count; ++s) std::fill_n(sums[s], n, 0.0);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t first = 0; first < n; first += targets_a_visit) {
    const TargetsInUnits local(targets, first, units);
    FieldTargets some{local.x, local.y, local.core, {}, local.size};
    for (std::size_t s = 0; s < Field::count; ++s) some.sums[s] = sums[s] + first;
    for (const PackedSources& packed : sources) {
      if (without) {
        field.add_bare(packed, some);
      } else {
        field.add_cored(packed, CoreShares(cores), some);
      }
    }
  }
}

Units checked(const Blobs& blobs, const Targets& targets, bool log) {
  const Units units = check(blobs);
  check(targets);
  for (const std::span<const double> sigma : {blobs.sigma, targets.sigma}) {
    const std::string complaint = complain_of_cores(sigma, units, log);
    if (!complaint.empty()) throw std::invalid_argument(complaint);
  }
  return units;
}

}  // namespace

void velocity_direct(const Blobs& blobs, const Targets& targets, Cores cores, std::span<double> u,
                     std::span<double> v) {
  check(blobs);
  check(targets);
  check_result(targets.size(), u, v);
  if (bare(blobs, targets, cores)) {
    sum_all<BarePair>(blobs, targets, u, v);
  } else if (cores == Cores::source) {
    sum_all<SourceCorePair<FineExp>>(blobs, targets, u, v);
  } else {
    sum_all<MeanCorePair<FineExp>>(blobs, targets, u, v);
  }
}

void gradient_direct(const Blobs& blobs, const Targets& targets, Cores cores, std::span<double> ux,
                     std::span<double> uy, std::span<double> vx) {
  const Units units = checked(blobs, targets, false);
  check_result(targets.size(), "ux", ux);
  check_result(targets.size(), "uy", uy);
  check_result(targets.size(), "vx", vx);
  sum_field(Gradient{}, blobs, targets, cores, units, {uy.data(), ux.data(), vx.data()});
  const std::size_t n = targets.size();
  units.check_range(sum_of_squares(ux) + sum_of_squares(uy) + sum_of_squares(vx), n, 1);
  finish_gradient(units, ux, uy, vx);
}

void stream_function_direct(const Blobs& blobs, const Targets& targets, Cores cores,
                            std::span<double> psi) {
  const Units units = checked(blobs, targets, true);
  check_result(targets.size(), "psi", psi);
  sum_field(StreamFunction{log_unit(units), {}}, blobs, targets, cores, units, {psi.data()});
  const double found = finish_stream_function(units, total(blobs, units), targets, psi);
  units.check_range(found, psi.size(), -1);
}

}  // namespace vortree::fmm
