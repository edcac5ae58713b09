#pragma once

#include <array>
#include <memory>
#include <vector>

#include "body/shape.hpp"
#include "sph/cloud/cloud.hpp"

namespace vortree::sph {

/// How spacing widens with the distance from where it is finest: s_0 within a distance w_0, then
/// wider and wider, linear between the distances at which it is that of a level,
///
///   s_{k+1} = 2 s_k   at   d_{k+1} = (w_k + w_{k+1})/2,   w_{k+1} = growth w_k + 2 s_{k+1},
///
/// up to the coarsest. Where that is more than two times as wide as the finest, d_{k+1} is
/// d_k + 4 s_k at least, so that spacing widens by a quarter of the distance at most. Twice as
/// steep, what the pressure leaves of the divergence grew from step to step where steps are too
/// short for viscosity to take it: the vortices of Taylor and Green, Re = 1000, 16 particles a
/// wavelength and three times finer in a disc, courant = 0.1, broke. With two times they hold, and
/// a wider strip of particles of all sizes costs a fifth in the error.
///
/// Steps of a factor of two, as lattices have them, leave particles two levels apart side by side,
/// whose neighbors tell them too little.
class Widening {
 public:
  Widening(double finest, double coarsest, double zone, double growth);

  [[nodiscard]] double at(double distance) const;
  [[nodiscard]] double finest() const { return spacing_.front(); }
  /// From this distance on it is the coarsest.
  [[nodiscard]] double end() const { return distance_.back(); }

 private:
  double coarsest_;
  std::vector<double> distance_, spacing_;  // of levels
};

/// How fine particles are to be at a place: the finest of what is wanted beside the body and in
/// regions, else the coarsest.
class WantedSpacing {
 public:
  /// shape    of the body, within whose `zone` particles are finest; null without one
  /// levels   the coarsest is 2^(levels - 1) times the finest
  /// period   of what is wanted, along x and y; 0: none
  WantedSpacing(std::shared_ptr<const body::Shape> shape, double finest, int levels, double zone,
                double growth, double period = 0);

  /// So fine within an ellipse, too, and wider from there on.
  ///
  /// half_axes   the one that is turned by `angle` from x, anticlockwise [radians], and the other
  void add_ellipse(Vec2 centre, std::array<double, 2> half_axes, double angle, double spacing);

  [[nodiscard]] double at(Vec2 at) const;
  [[nodiscard]] double finest() const;
  [[nodiscard]] double coarsest() const { return coarsest_; }

 private:
  struct Wish {
    std::shared_ptr<const body::Shape> shape;
    Widening widening;
  };

  [[nodiscard]] double nearest(Vec2 at) const;

  double coarsest_, growth_, period_;
  std::vector<Wish> wishes_;
};

}  // namespace vortree::sph
