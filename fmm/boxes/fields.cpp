#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "fmm/boxes/batch.hpp"
#include "fmm/boxes/boxes.hpp"
#include "fmm/boxes/far.hpp"
#include "fmm/field/field.hpp"
#include "fmm/near/near.hpp"

namespace vortree::fmm {

/// Each leaf of the targets' tree looks for its own series and near sources, from the root on.
template <class Field>
Expected Boxes::evaluate_field(const Field& field, const SeriesOrder& order, const Arrangement& at,
                               std::array<double*, 3> results) const {
  const std::size_t n = at.points.size();
  for (std::size_t s = 0; s < Field::count; ++s) std::fill_n(results[s], n, 0.0);
  if (n == 0 || sources_.points.size() == 0) return {};
  Acceptance accepted = acceptance(cored(at));
  accepted.order = order;
  if (accepted.reach2 > 0.0) accepted.reach2 = Field::reach2(options_.tolerance);
  const auto leaves = at.tree.childless();
  std::vector<Expected> expected(leaves.size());
  const std::uint32_t root[] = {0};
#pragma omp parallel
  {
    Interactions found;
    NearSources near;
    Batch batch;
    std::array<std::vector<double>, Field::count> sums;
#pragma omp for schedule(dynamic)
    for (std::size_t k = 0; k < leaves.size(); ++k) {
      const tree::Range own = at.tree.cells()[leaves[k]].points;
      const TargetBox around = box(at.shapes, leaves[k]);
      batch.take(at.points, own, around);
      FieldTargets some{batch.x.data(), batch.y.data(), batch.core.data(), {}, batch.size};
      for (std::size_t s = 0; s < Field::count; ++s) {
        sums[s].assign(batch.x.size(), 0.0);
        some.sums[s] = sums[s].data();
      }
      find_interactions(sources_.tree, sources_.shapes, around, accepted, root, found);
      for (const SeriesCell met : found.series) {
        const CellFrame frame{sources_.shapes.x[met.cell], sources_.shapes.y[met.cell], 0.0, 0.0,
                              scale(sources_.shapes, met.cell)};
        field.add_multipole(SeriesView<double>{multipoles_.real(met.cell),
                                               multipoles_.imaginary(met.cell), met.terms},
                            frame, some);
      }
      near.pack(sources_.points, gamma_, around, accepted, found);
      near.sum(field, CoreShares(options_.cores), some);
      for (std::size_t s = 0; s < Field::count; ++s) {
        for (std::uint32_t j = own.first; j < own.last; ++j) {
          results[s][at.tree.order()[j]] = sums[s][j - own.first];
        }
        expected[k].found += sum_of_squares(std::span(sums[s]).first(own.size()));
      }
      Lost lost = near.lost(accepted.reach2, Field::derivative, false);
      lost += lost_by_series(multipoles_, accepted, found.series, Field::derivative);
      expected[k].lost = static_cast<double>(own.size()) * lost;
    }
  }
  return total(expected);
}

Expected Boxes::gradient_at(const Arrangement& targets, std::span<double> ux, std::span<double> uy,
                            std::span<double> vx) const {
  if (phase_) phase_("evaluate");
  const int terms = order_.most();
  const SeriesOrder order = options_.order > 0
                                ? order_
                                : SeriesOrder::fixed(terms, slope_ratio(options_.tolerance, terms));
  const Expected expected =
      evaluate_field(FieldGradient{}, order, targets, {uy.data(), ux.data(), vx.data()});
  units_.check_range(expected.found, targets.points.size(), 1);
  finish_gradient(units_, ux, uy, vx);
  return expected;
}

Expected Boxes::gradient(const Targets& targets, std::span<double> ux, std::span<double> uy,
                         std::span<double> vx) const {
  return gradient_at(arrange(targets, units_, growth()), ux, uy, vx);
}

Expected Boxes::velocity_and_gradient(std::span<double> u, std::span<double> v,
                                      std::span<double> ux, std::span<double> uy,
                                      std::span<double> vx) const {
  const Expected expected = velocity(u, v);
  return worse(expected, gradient_at(sources_, ux, uy, vx));
}

Expected Boxes::stream_function(const Targets& targets, std::span<double> psi) const {
  if (phase_) phase_("evaluate");
  Expected expected = evaluate_field(StreamFunction{log_unit(units_), {}}, order_,
                                     arrange(targets, units_, growth()), {psi.data()});
  const double all = std::accumulate(gamma_.begin(), gamma_.end(), 0.0);
  expected.found = finish_stream_function(units_, all, targets, psi);
  units_.check_range(expected.found, psi.size(), -1);
  return expected;
}

}  // namespace vortree::fmm
