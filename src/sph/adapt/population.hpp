#pragma once

#include <vector>

#include "sph/cloud/cloud.hpp"
#include "sph/operators/derivatives.hpp"
#include "sph/operators/stencils.hpp"

namespace vortree::sph {

/// A cloud while particles come and go. Neighbors and slopes are those of the last step: particles
/// have moved since by a fraction of their spacing.
class Population {
 public:
  /// period   sides of a periodic domain [L]; 0: not periodic
  Population(Cloud& cloud, const Stencils& stencils, const std::vector<Slopes>& slopes,
             double period = 0)
      : cloud_(cloud),
        stencils_(stencils),
        slopes_(slopes),
        period_(period),
        gone_(cloud.size(), 0) {}

  /// Those that had neighbors when the step began.
  [[nodiscard]] std::size_t old() const { return stencils_.size(); }
  [[nodiscard]] const Cloud& cloud() const { return cloud_; }
  [[nodiscard]] bool gone(std::size_t i) const { return gone_[i]; }
  [[nodiscard]] double filling(std::size_t i) const { return stencils_.filling(i); }
  [[nodiscard]] double nearest(std::size_t i) const { return stencils_.nearest(i); }

  [[nodiscard]] double vorticity(std::size_t i) const { return sph::vorticity(slopes_[i]); }

  [[nodiscard]] std::vector<char> beside_edge() const { return stencils_.beside_edge(cloud_); }

  /// For each old neighbor that is still there: use(j, where it is now as seen from i).
  template <class Use>
  void for_each_neighbor(std::size_t i, const Use& use) const {
    stencils_.for_each(i, [&](std::size_t j, std::size_t) {
      if (!gone_[j]) use(j, nearest_image(cloud_.at(j) - cloud_.at(i), period_));
    });
  }

  void remove(std::size_t i) { gone_[i] = 1; }
  void resize(std::size_t i, double spacing) { cloud_.spacing[i] = spacing; }

  /// A new free particle `by` away from an old one, that carries what is there: by the series of
  /// the parent, or in the mean of those of all around (operators/interpolate.hpp).
  std::size_t add(std::size_t parent, Vec2 by, double spacing);
  std::size_t add_among(std::size_t node, Vec2 by, double spacing);

  /// One in place of two, of their volume and at its centre.
  std::size_t merge(std::size_t i, std::size_t j);

  /// Takes away those that are gone.
  void finish() { cloud_.remove(gone_); }

 private:
  std::size_t put(Vec2 at, double spacing, const std::array<double, carried_count>& values);

  Cloud& cloud_;
  const Stencils& stencils_;
  const std::vector<Slopes>& slopes_;
  double period_;
  std::vector<char> gone_;
};

}  // namespace vortree::sph
