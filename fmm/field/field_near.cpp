#include "fmm/field/field.hpp"
#include "fmm/field/field_kernel.hpp"

namespace vortree::fmm {
namespace {

/// `act<rows>(first)` for all targets, two at a time.
template <class Act>
void in_pairs(const PackedSources& sources, const FieldTargets& targets, Act act) {
  if (sources.size() == 0) return;
  std::size_t i = 0;
  for (; i + 2 <= targets.size; i += 2) act.template operator()<2>(i);
  if (i < targets.size) act.template operator()<1>(i);
}

}  // namespace

void FieldGradient::add_bare(const PackedSources& sources, const FieldTargets& targets) const {
  in_pairs(sources, targets,
           [&]<int rows>(std::size_t i) { gradient_bare<rows>(sources, targets, i); });
}

void FieldGradient::add_cored(const PackedSources& sources, CoreShares shares,
                              const FieldTargets& targets) const {
  in_pairs(sources, targets,
           [&]<int rows>(std::size_t i) { gradient_cored<rows>(sources, shares, targets, i); });
}

void StreamFunction::add_bare(const PackedSources& sources, const FieldTargets& targets) const {
  in_pairs(sources, targets,
           [&]<int rows>(std::size_t i) { stream_bare<rows>(sources, unit, targets, i); });
}

void StreamFunction::add_cored(const PackedSources& sources, CoreShares shares,
                               const FieldTargets& targets) const {
  in_pairs(sources, targets,
           [&]<int rows>(std::size_t i) { stream_cored<rows>(sources, shares, unit, targets, i); });
}

}  // namespace vortree::fmm
