#include "fmm/evaluate.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fmm/multipole_kernel.hpp"
#include "fmm/p2p_kernel.hpp"

namespace vortree::fmm {
namespace {

/// Beyond this tolerance the shorter exponential is exact enough.
constexpr double coarse_tolerance = 1e-7;

/// What a thread needs for one leaf, kept for the next one.
struct Scratch {
  Interactions found;
  Packed bare, cored;
  std::vector<double> x, y, core, u, v;  // the leaf's targets, filled up to whole vectors

  void take(const SortedPoints& points, tree::Range range) {
    const std::size_t n = range.size();
    for (auto* values : {&x, &y, &core, &u, &v}) values->assign(padded(n), 0.0);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const std::size_t from = range.first + std::min(i, n - 1);
      x[i] = points.x[from], y[i] = points.y[from], core[i] = points.core[from];
    }
  }
};

TargetBox box(const CellShapes& shapes, std::size_t cell) {
  return {shapes.x[cell], shapes.y[cell], shapes.half_x[cell], shapes.half_y[cell],
          shapes.core[cell]};
}

/// Near sources one beside the other, parted anew: in a cell whose cores may show, most sources are
/// still too far from this leaf for their own core to show.
template <class Pair>
void pack(const SourceSide& sources, const TargetBox& target, const Acceptance& acceptance,
          Scratch& scratch) {
  std::size_t near = 0;
  for (const tree::Range run : scratch.found.bare) near += run.size();
  for (const tree::Range run : scratch.found.cored) near += run.size();
  scratch.bare.restart(near);
  scratch.cored.restart(near);
  const SortedPoints& points = sources.points;
  for (const tree::Range run : scratch.found.bare) {
    for (std::uint32_t j = run.first; j < run.last; ++j) {
      scratch.bare.add(points.x[j], points.y[j], sources.gamma[j], 0.0);
    }
  }
  for (const tree::Range run : scratch.found.cored) {
    for (std::uint32_t j = run.first; j < run.last; ++j) {
      const double dx = std::max(0.0, std::abs(points.x[j] - target.x) - target.half_x);
      const double dy = std::max(0.0, std::abs(points.y[j] - target.y) - target.half_y);
      if (dx * dx + dy * dy >= acceptance.squared_reach(points.core[j], target.core)) {
        scratch.bare.add(points.x[j], points.y[j], sources.gamma[j], 0.0);
      } else {
        scratch.cored.add(points.x[j], points.y[j], sources.gamma[j],
                          Pair::packed_core(points.core[j]));
      }
    }
  }
  scratch.bare.close();
  scratch.cored.close();
}

template <int rows>
void add_series_rows(const SourceSide& sources, Scratch& scratch, std::size_t first) {
  for (const SeriesCell met : scratch.found.series) {
    const M2pSource source{sources.shapes.x[met.cell],
                           sources.shapes.y[met.cell],
                           scale(sources.shapes, met.cell),
                           sources.multipoles.real(met.cell),
                           sources.multipoles.imaginary(met.cell),
                           met.terms};
    m2p_rows<rows>(source, &scratch.x[first], &scratch.y[first], &scratch.u[first],
                   &scratch.v[first]);
  }
}

void add_series(const SourceSide& sources, Scratch& scratch) {
  constexpr std::size_t most = 4 * lane_count;
  std::size_t i = 0;
  for (; i + most <= scratch.x.size(); i += most) add_series_rows<4>(sources, scratch, i);
  switch ((scratch.x.size() - i) / lane_count) {
    case 3:
      return add_series_rows<3>(sources, scratch, i);
    case 2:
      return add_series_rows<2>(sources, scratch, i);
    case 1:
      return add_series_rows<1>(sources, scratch, i);
    default:
      return;
  }
}

template <class Pair>
void evaluate_leaf(const SourceSide& sources, const TargetSide& targets, std::uint32_t leaf,
                   const Acceptance& acceptance, Scratch& scratch) {
  const tree::Range range = targets.tree.cells()[leaf].points;
  const TargetBox target = box(targets.shapes, leaf);
  find_interactions(sources.tree, sources.shapes, target, acceptance, scratch.found);
  scratch.take(targets.points, range);
  add_series(sources, scratch);
  pack<Pair>(sources, target, acceptance, scratch);
  const NearTargets near{scratch.x.data(), scratch.y.data(), scratch.core.data(),
                         scratch.u.data(), scratch.v.data(), range.size()};
  p2p<BarePair>(scratch.bare, near);
  p2p<Pair>(scratch.cored, near);
}

template <class Pair>
void evaluate_with(const SourceSide& sources, const TargetSide& targets,
                   const Acceptance& acceptance, std::span<double> u, std::span<double> v) {
  const auto leaves = targets.tree.childless();
  const auto order = targets.tree.order();
#pragma omp parallel
  {
    Scratch scratch;
#pragma omp for schedule(dynamic, 4)
    for (std::size_t k = 0; k < leaves.size(); ++k) {
      evaluate_leaf<Pair>(sources, targets, leaves[k], acceptance, scratch);
      const tree::Range range = targets.tree.cells()[leaves[k]].points;
      for (std::uint32_t j = range.first; j < range.last; ++j) {
        u[order[j]] = scratch.u[j - range.first];
        v[order[j]] = scratch.v[j - range.first];
      }
    }
  }
}

}  // namespace

void evaluate(const SourceSide& sources, const TargetSide& targets, const Acceptance& acceptance,
              double tolerance, std::span<double> u, std::span<double> v) {
  const bool coarse = tolerance >= coarse_tolerance;
  if (acceptance.reach2 == 0.0) {
    evaluate_with<BarePair>(sources, targets, acceptance, u, v);
  } else if (acceptance.cores == Cores::mean) {
    if (coarse) {
      evaluate_with<MeanCorePair<CoarseExp>>(sources, targets, acceptance, u, v);
    } else {
      evaluate_with<MeanCorePair<FineExp>>(sources, targets, acceptance, u, v);
    }
  } else if (coarse) {
    evaluate_with<SourceCorePair<CoarseExp>>(sources, targets, acceptance, u, v);
  } else {
    evaluate_with<SourceCorePair<FineExp>>(sources, targets, acceptance, u, v);
  }
}

Work count_work(const SourceSide& sources, const TargetSide& targets,
                const Acceptance& acceptance) {
  Work work;
  Scratch scratch;
  for (const std::uint32_t leaf : targets.tree.childless()) {
    const TargetBox target = box(targets.shapes, leaf);
    const std::uint64_t n = targets.tree.cells()[leaf].points.size();
    find_interactions(sources.tree, sources.shapes, target, acceptance, scratch.found);
    pack<BarePair>(sources, target, acceptance, scratch);
    work.series += scratch.found.series.size();
    for (const SeriesCell met : scratch.found.series) work.terms += n * met.terms;
    work.bare += n * scratch.bare.size();
    work.cored += n * scratch.cored.size();
  }
  return work;
}

}  // namespace vortree::fmm
