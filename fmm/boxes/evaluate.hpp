#pragma once

#include <cstdint>
#include <span>

#include "fmm/evaluator.hpp"
#include "fmm/geometry/arrangement.hpp"
#include "fmm/lists/interactions.hpp"
#include "fmm/series/multipoles.hpp"

namespace vortree::fmm {

/// Sources as the evaluation reads them: gamma in the order of the arrangement.
struct ArrangedSources {
  const Arrangement& at;
  const Multipoles& multipoles;
  std::span<const double> gamma;
};

/// Box-to-point evaluation, sums without the factor 1/(2 pi): series of far cells straight to the
/// targets, near sources one by one.
///
/// targets  the childless cells of their tree are evaluated one by one
/// coarse   single precision is exact enough for cored near sums
/// u, v     one a target, in input order; overwritten
/// returns  what was found, and what of it is expected to be lost
/// Each block of leaves is summed by one thread in a fixed order: the result does not depend on the
/// threads.
Expected evaluate(const ArrangedSources& sources, const Arrangement& targets,
                  const Acceptance& acceptance, bool coarse, std::span<double> u,
                  std::span<double> v);

/// The work of evaluate(), counted.
[[nodiscard]] Work count_work(const ArrangedSources& sources, const Arrangement& targets,
                              const Acceptance& acceptance);

}  // namespace vortree::fmm
