#include <vector>

#include "neighbors/exact_pairs.hpp"
#include "neighbors/row_by_row.hpp"
#include "tree/base/simd.hpp"

// Compiled without fused operations: see tree/neighbors/pair_rule.hpp.
namespace vortree::neighbors {
namespace {

using tree::PairRule;

// The reach of each pair, as tree::pair_reach.
template <PairRule rule>
Lanes pair_reach(double own, Lanes others) {
  if constexpr (rule == PairRule::max) return larger(fill(own), others);
  if constexpr (rule == PairRule::mean) return 0.5 * (own + others);
  return fill(own);
}

// A register full of particles at a time.
class AllPairs : public RowByRow<AllPairs> {
 public:
  void build(const NeighborJob&) override {}

  // Those lanes from particle j on whose squares overflow or underflow.
  template <PairRule rule>
  static LaneSet test_few(const NeighborJob& job, std::size_t i, std::size_t j, LaneSet lanes) {
    LaneSet hits = 0;
    for (; lanes != 0; lanes &= lanes - 1) {
      const auto k = static_cast<unsigned>(std::countr_zero(lanes));
      hits |= static_cast<LaneSet>(is_pair<rule>(job, i, j + k)) << k;
    }
    return hits;
  }

  template <PairRule rule>
  void find(const NeighborJob& job, std::size_t i, std::vector<std::int32_t>& row) const {
    const double *x = job.points.x.data(), *y = job.points.y.data(), *reach = job.reach.data();
    const bool once = job.listing == tree::Listing::once;
    const std::size_t n = job.points.size();
    for (std::size_t j = 0; j < n; j += lane_count) {
      const LaneSet there = first_lanes(n - j);
      const bool whole = j + lane_count <= n;
      const Lanes dx = (whole ? load(x + j) : load(x + j, there)) - x[i];
      const Lanes dy = (whole ? load(y + j) : load(y + j, there)) - y[i];
      const Lanes r = pair_reach<rule>(reach[i], whole ? load(reach + j) : load(reach + j, there));
      const Lanes limit = r * r;
      LaneSet hits = where(dx * dx + dy * dy < limit) & there;
      const LaneSet odd =
          where((limit < tree::least_square) | (limit > tree::largest_square)) & there;
      if (odd != 0) hits = test_few<rule>(job, i, j, odd) | (hits & ~odd);
      for (; hits != 0; hits &= hits - 1) {
        const std::size_t k = j + static_cast<std::size_t>(std::countr_zero(hits));
        if (k != i && (!once || keeps(job, i, k))) row.push_back(static_cast<std::int32_t>(k));
      }
    }
  }
};

}  // namespace

std::unique_ptr<NeighborMethod> make_all_pairs() {
  return std::make_unique<AllPairs>();
}

}  // namespace vortree::neighbors
