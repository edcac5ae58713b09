#include "sph/neighbors/periodic_images.hpp"

#include <algorithm>
#include <numeric>

namespace vortree::sph {

void PeriodicImages::renew(tree::Points points, std::span<const double> reach_,
                           std::span<const std::int32_t> was_, double side) {
  const std::size_t n = points.size();
  const double margin = n == 0 ? 0 : std::ranges::max(reach_);
  x.assign(points.x.begin(), points.x.end()), y.assign(points.y.begin(), points.y.end());
  reach.assign(reach_.begin(), reach_.end()), was.assign(was_.begin(), was_.end());
  of.resize(n);
  std::iota(of.begin(), of.end(), 0);
  number_.swap(before_);
  number_.assign(copies * n, -1);
  if (side == 0) return;
  std::size_t copy = 0;
  for (int a = -1; a <= 1; ++a)
    for (int b = -1; b <= 1; ++b, ++copy)
      for (std::size_t i = 0; i < n; ++i) {
        const double to_x = points.x[i] + a * side, to_y = points.y[i] + b * side;
        const bool near =
            to_x > -margin && to_x < side + margin && to_y > -margin && to_y < side + margin;
        if ((a == 0 && b == 0) || !near) continue;
        const std::size_t old = copies * static_cast<std::size_t>(was_[i]) + copy;
        was.push_back(was_[i] >= 0 && old < before_.size() ? before_[old] : -1);
        number_[copies * i + copy] = static_cast<std::int32_t>(x.size());
        x.push_back(to_x), y.push_back(to_y), reach.push_back(reach_[i]);
        of.push_back(static_cast<std::int32_t>(i));
      }
}

}  // namespace vortree::sph
