#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "tree/clouds.hpp"

/// Reaches to try neighbor searches with.
namespace vortree::test {

inline constexpr int reach_kinds = 7;

/// Reaches for points that spread over `extent`.
inline std::vector<double> make_reach(int kind, std::size_t n, double extent, Chance& chance) {
  std::vector<double> reach(n);
  const double typical = extent / std::sqrt(static_cast<double>(n) + 1);
  for (double& r : reach) {
    const double s = chance.real();
    switch (kind) {
      case 0:  // the same for all
        r = 2 * typical;
        break;
      case 1:  // continuous
        r = typical * (0.5 + 3 * s);
        break;
      case 2:  // halved from level to level
        r = 4 * typical * std::ldexp(1.0, -chance.whole(0, 5));
        break;
      case 3:  // a ratio of a million
        r = extent * std::pow(10.0, -6 * s);
        break;
      case 4:  // some reach beyond everything
        r = chance.whole(0, 20) == 0 ? extent * std::pow(10.0, 300 * s) : typical * s;
        break;
      case 5:  // half reach nobody
        r = s < 0.5 ? 0 : typical * s;
        break;
      default:
        r = 0;
        break;
    }
  }
  return reach;
}

/// How far the points of a cloud spread, 1 if not at all.
inline double extent_of(const Cloud& cloud) {
  double widest = 0;
  for (std::size_t i = 1; i < cloud.x.size(); ++i) {
    widest =
        std::max({widest, std::abs(cloud.x[i] - cloud.x[0]), std::abs(cloud.y[i] - cloud.y[0])});
  }
  return widest > 0 ? widest : 1.0;
}

}  // namespace vortree::test
