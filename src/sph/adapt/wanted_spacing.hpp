#pragma once

#include <memory>
#include <vector>

#include "body/shape.hpp"
#include "sph/cloud/cloud.hpp"

namespace vortree::sph {

/// How fine particles are to be: s_0 within a distance w_0 of the body, then wider and wider,
/// linear in the distance between those at which the spacing is that of a level,
///
///   s_{k+1} = 2 s_k   at   d_{k+1} = (w_k + w_{k+1})/2,   w_{k+1} = growth w_k + 2 s_{k+1},
///
/// and that of the last level beyond. Without a body, s_0 everywhere.
///
/// Steps of a factor of two, as lattices have them, leave particles two levels apart side by side,
/// whose neighbors tell them too little.
class WantedSpacing {
 public:
  WantedSpacing(std::shared_ptr<const body::Shape> shape, double finest, int levels, double zone,
                double growth);

  [[nodiscard]] double at(Vec2 at) const;
  [[nodiscard]] double finest() const { return spacing_.front(); }
  [[nodiscard]] double coarsest() const { return spacing_.back(); }

 private:
  std::shared_ptr<const body::Shape> shape_;
  std::vector<double> distance_, spacing_;  // of levels
};

}  // namespace vortree::sph
