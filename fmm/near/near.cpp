#include "fmm/near/near.hpp"

#include <algorithm>

#include "fmm/geometry/units.hpp"

namespace vortree::fmm {

void NearSources::pack(const SortedPoints& points, std::span<const double> gamma,
                       const TargetBox& leaf, const Acceptance& acceptance,
                       const Interactions& found) {
  std::size_t shown = 0, near = 0;
  for (const tree::Range run : found.cored) shown += run.size();
  for (const tree::Range run : found.bare) near += run.size();
  bare_.restart(near);
  hidden_.restart(shown);
  cored_.restart(shown);
  for (const tree::Range run : found.bare) {
    bare_.add(&points.x[run.first], &points.y[run.first], &gamma[run.first], run.size());
  }
  part(points, gamma, leaf, acceptance, found.cored);
  for (PackedSources* sources : {&bare_, &hidden_, &cored_}) sources->close();
}

/// Far enough from the leaf's box: hidden; else cored.
void NearSources::part(const SortedPoints& points, std::span<const double> gamma,
                       const TargetBox& leaf, const Acceptance& acceptance,
                       std::span<const tree::Range> runs) {
  const double own = acceptance.cores == Cores::source ? 1.0 : 0.5;
  const double reach2 = own * acceptance.reach2;
  const double others = acceptance.squared_reach(0.0, leaf.core);
  const double *all_x = points.x.data(), *all_y = points.y.data(),
               *all_core = points.core.data();  // none: bare
  const TargetBox box = leaf;
  PackedSources::Writer hidden(hidden_), cored(cored_);
  Lanes most = fill(std::max(box.half_x, box.half_y)), least = fill(Units::largest_core);
  Lanes widest = fill(box.core), squares{};
  for (const tree::Range run : runs) {
    for (std::uint32_t j = run.first; j < run.last; j += lane_count) {
      const LaneSet some = first_lanes(run.last - j);
      const Lanes x = load(all_x + j, some, box.x), y = load(all_y + j, some, box.y);
      const Lanes core = points.core.empty() ? Lanes{} : load(all_core + j, some, all_core[j]);
      const Lanes strength = load(gamma.data() + j, some);
      const Lanes from_x = magnitude(x - box.x), from_y = magnitude(y - box.y);
      const Lanes dx = larger(from_x - box.half_x, Lanes{});
      const Lanes dy = larger(from_y - box.half_y, Lanes{});
      const LaneSet far = some & where(dx * dx + dy * dy >= core * reach2 + others);
      hidden.add(x, y, strength, far);
      cored.add(x, y, strength, core, some & ~far);
      squares += strength * strength;
      most = larger(larger(from_x, from_y), most);
      least = smaller(core, least), widest = larger(core, widest);
    }
  }
  hidden.finish(hidden_);
  cored.finish(cored_);
  size_ = largest(most), least_core_ = -largest(-least), widest_core_ = largest(widest);
  squares_ = vortree::sum(squares);
}

}  // namespace vortree::fmm
