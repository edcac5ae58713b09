#pragma once

#include <cstdint>
#include <span>

#include "fmm/cells.hpp"
#include "fmm/interactions.hpp"
#include "fmm/multipoles.hpp"
#include "tree/quadtree.hpp"

namespace vortree::fmm {

/// Sources as the evaluation reads them: everything in Morton order and in Units.
struct SourceSide {
  const tree::Quadtree& tree;
  const CellShapes& shapes;
  const Multipoles& multipoles;
  const SortedPoints& points;
  std::span<const double> gamma;
};

/// Targets in Morton order; the childless cells of their tree are evaluated one by one.
struct TargetSide {
  const tree::Quadtree& tree;
  const CellShapes& shapes;
  const SortedPoints& points;
};

/// How much an evaluation computes.
///
/// series   cells met by their series, once for each target leaf or block of leaves
/// terms    terms of them, once for each target
/// bare     pairs of target and source summed without core
/// cored    pairs summed with core
struct Work {
  std::uint64_t series = 0, terms = 0, bare = 0, cored = 0;
};

/// Box-to-point evaluation, sums without the factor 1/(2 pi): series of far cells straight to the
/// targets, near sources one by one.
///
/// u, v     one a target, in input order; overwritten
/// Each block of leaves is summed by one thread in a fixed order: the result does not depend on the
/// threads.
void evaluate(const SourceSide& sources, const TargetSide& targets, const Acceptance& acceptance,
              double tolerance, std::span<double> u, std::span<double> v);

/// The work of evaluate(), counted.
[[nodiscard]] Work count_work(const SourceSide& sources, const TargetSide& targets,
                              const Acceptance& acceptance);

}  // namespace vortree::fmm
