#include "fmm/near.hpp"

#include <algorithm>

namespace vortree::fmm {

void NearSources::pack(const SortedPoints& points, std::span<const double> gamma,
                       const TargetBox& leaf, const Acceptance& acceptance,
                       const Interactions& found) {
  std::size_t shown = 0, near = 0;
  for (const tree::Range run : found.cored) shown += run.size();
  for (const tree::Range run : found.bare) near += run.size();
  bare_.restart(near + shown);
  cored_.restart(shown);
  for (const tree::Range run : found.bare) {
    bare_.add(&points.x[run.first], &points.y[run.first], &gamma[run.first], run.size());
  }
  part(points, gamma, leaf, acceptance, found.cored);
  bare_.close();
  cored_.close();
}

/// Far enough from the leaf's box: bare; else cored.
void NearSources::part(const SortedPoints& points, std::span<const double> gamma,
                       const TargetBox& leaf, const Acceptance& acceptance,
                       std::span<const tree::Range> runs) {
  const double own = acceptance.cores == Cores::source ? 1.0 : 0.5;
  const double reach2 = own * acceptance.reach2;
  const double others = acceptance.squared_reach(0.0, leaf.core);
  const double *all_x = points.x.data(), *all_y = points.y.data(), *all_core = points.core.data();
  const TargetBox box = leaf;
  Packed::Writer bare(bare_), cored(cored_);
  for (const tree::Range run : runs) {
    for (std::uint32_t j = run.first; j < run.last; j += lane_count) {
      const LaneSet some = first_lanes(run.last - j);
      const Lanes x = load(all_x + j, some), y = load(all_y + j, some);
      const Lanes core = load(all_core + j, some), strength = load(gamma.data() + j, some);
      const Lanes dx = larger(magnitude(x - box.x) - box.half_x, Lanes{});
      const Lanes dy = larger(magnitude(y - box.y) - box.half_y, Lanes{});
      const LaneSet hidden = some & where(dx * dx + dy * dy >= core * reach2 + others);
      bare.add(x, y, strength, hidden);
      cored.add(x, y, strength, core, some & ~hidden);
    }
  }
  bare.finish(bare_);
  cored.finish(cored_);
}

SingleFrame NearSources::frame_of(const TargetBox& leaf) const {
  Lanes most = fill(std::max(leaf.half_x, leaf.half_y));
  for (std::size_t j = 0; j < cored_.size(); j += lane_count) {
    most = larger(magnitude(load(cored_.x() + j) - leaf.x), most);
    most = larger(magnitude(load(cored_.y() + j) - leaf.y), most);
  }
  return {leaf.x, leaf.y, largest(most)};
}

/// Cores wide enough for the frame, and none beyond the range of floats.
bool NearSources::fits_single(const SingleFrame& frame, double target_core) const {
  Lanes least = load(cored_.core()), most = fill(target_core);
  for (std::size_t j = 0; j < cored_.size(); j += lane_count) {
    least = smaller(load(cored_.core() + j), least);
    most = larger(load(cored_.core() + j), most);
  }
  const double area = frame.size * frame.size;
  return area <= widest_frame2 * -largest(-least) && largest(most) <= 1e30 * area;
}

}  // namespace vortree::fmm
