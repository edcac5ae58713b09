#pragma once

#include "flows.hpp"
#include "vortex/cores/folded_centroid.hpp"

/// Blobs with strained cores, and a flat wall for them.
namespace vortree::test {

/// The half plane y < 0 is the body: what claims about a flat wall are exact at.
class FlatWall final : public body::Shape {
 public:
  double perimeter() const override { return INFINITY; }
  Vec2 point(double arc) const override { return {-arc, 0}; }
  body::WallPoint nearest(Vec2 at) const override { return {-at.x, at.y, {0, 1}, 0}; }
};

/// A deviator of any direction, of `part` of the largest that leaves a core its positive variances.
inline vortex::Deviator strain(Uniform& uniform, double square, double part) {
  const double phi = 2 * std::numbers::pi * uniform(), size = part * square / 2;
  return {size * std::cos(phi), size * std::sin(phi)};
}

/// The same blobs, each strained by up to `most` of what its core can bear.
inline vortex::Blobs strained(vortex::Blobs blobs, double most) {
  Uniform uniform(23);
  for (std::size_t i = 0; i < blobs.size(); ++i) {
    const vortex::Core core = blobs.core(i);
    const vortex::Deviator d = strain(uniform, core.square, most * std::sqrt(uniform()));
    blobs.xx[i] = d.xx;
    blobs.xy[i] = d.xy;
  }
  return blobs;
}

/// sum gamma (X X^T + V) of free blobs: xx, xy, yy, all that splitting and merging are to keep.
inline vortex::Covariance second_moments(const vortex::Blobs& blobs) {
  vortex::Covariance sum{};
  for (std::size_t i = 0; i < blobs.size(); ++i) {
    const auto [x, y] = blobs.centre(i);
    const double g = blobs.gamma[i], half = blobs.sigma[i] * blobs.sigma[i] / 2;
    sum.nn += g * (x * x + half + blobs.xx[i]);
    sum.nt += g * (x * y + blobs.xy[i]);
    sum.tt += g * (y * y + half - blobs.xx[i]);
  }
  return sum;
}

/// The largest entry of a difference.
inline double difference(const vortex::Covariance& a, const vortex::Covariance& b) {
  return std::max({std::abs(a.nn - b.nn), std::abs(a.nt - b.nt), std::abs(a.tt - b.tt)});
}

/// True if no core has a variance below 0, or anything that is no number.
inline bool all_sound(const vortex::Blobs& blobs) {
  for (std::size_t i = 0; i < blobs.size(); ++i) {
    const vortex::Core core = blobs.core(i);
    const bool finite = std::isfinite(blobs.x[i] + blobs.y[i] + blobs.gamma[i] + core.square);
    if (!finite || !(core.deviator.size() <= core.square / 2 * (1 + 1e-12))) return false;
  }
  return true;
}

}  // namespace vortree::test
