#include "vortex/split_wide.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <span>

#include "vortex/folded_core.hpp"
#include "vortex/hash.hpp"

namespace vortree::vortex {
namespace {

/// About six digits: mirror images that differ by round-off still turn alike.
std::uint64_t rounded(double a) {
  return (std::bit_cast<std::uint64_t>(a) + (1ull << 31)) >> 32;
}

Vec2 direction(double phi) {
  return {std::cos(phi), std::sin(phi)};
}

/// Rings of children, of radius 1.
class Rings {
 public:
  Rings(const Splitting& splitting, std::uint64_t step)
      : hash_(mixed(splitting.seed ^ mixed(step))) {
    const double sector = 2 * std::numbers::pi / splitting.children;
    for (int c = 0; c < splitting.children; ++c) child_.push_back(direction(sector * c));
    for (std::size_t k = 0; k < turn_.size(); ++k)
      turn_[k] = direction(sector * static_cast<double>(k) / turn_.size());
  }

  /// How far the ring of a blob is turned, as a unit vector.
  Vec2 turn(double gamma, double sigma) const {
    const std::uint64_t hash = mixed(hash_ ^ rounded(std::abs(gamma)) ^ (rounded(sigma) << 32));
    const Vec2 turned = turn_[hash % turn_.size()];
    return {turned.x, std::copysign(turned.y, gamma)};
  }

  Vec2 child(Vec2 turned, int c) const {
    const Vec2 at = child_[c];
    return {turned.x * at.x - turned.y * at.y, turned.y * at.x + turned.x * at.y};
  }

 private:
  std::uint64_t hash_;
  std::vector<Vec2> child_;
  std::array<Vec2, 1024> turn_;
};

/// A blob's children beside the wall: those that land in the body are reflected, and all are to act
/// so far from where they would that their mean stays.
void hold_mean(std::span<Part> children, std::span<AtWall> at_wall, Vec2 mean, const Shape& wall) {
  const double sigma = std::sqrt(children[0].square);
  Vec2 sum;
  for (std::size_t c = 0; c < children.size(); ++c) {
    Part& child = children[c];
    WallPoint w = wall.nearest(child.centre());
    if (w.distance < 0) {
      const Vec2 back = child.centre() - (2 * w.distance) * w.normal;
      child.x = back.x;
      child.y = back.y;
      w.distance = -w.distance;
    }
    at_wall[c] = beside(w, sigma);
    sum = sum + child.centre() + at_wall[c].offset;
  }
  const Vec2 shift = mean - (1.0 / static_cast<double>(children.size())) * sum;
  for (AtWall& child : at_wall) {
    child.offset = child.offset + shift;
    child.moved = true;
  }
}

/// Where the parts of each blob begin, and what they know of the wall.
struct Places {
  std::vector<std::uint32_t> part, at_wall;
  std::vector<float> widening;

  Places(const Blobs& blobs, double widest, const Splitting& splitting, const Shape* wall)
      : part(blobs.size() + 1), at_wall(blobs.size() + 1), widening(blobs.size(), 1.0f) {
    const auto n = static_cast<std::ptrdiff_t>(blobs.size());
    const double alpha = splitting.alpha;
    const bool coarsens = wall && !splitting.coarsening.everywhere_alike();
    const double reach_of_split =
        std::max(folded::reach, knows_wall * alpha) + std::sqrt(1 - alpha * alpha);
    const double farthest = std::max(reach_of_split, knows_wall);
#pragma omp parallel for schedule(static)
    for (std::ptrdiff_t i = 0; i < n; ++i) {
      const double s = blobs.sigma[i];
      const bool near = wall && !wall->beyond(blobs.centre(i), farthest * s);
      const double distance = near || coarsens ? wall->distance(blobs.centre(i)) : INFINITY;
      if (coarsens) widening[i] = splitting.coarsening.widening(distance);
      const bool splits = s > widest * widening[i];
      part[i + 1] = splits ? splitting.children : 1;
      const double reach = splits ? reach_of_split : knows_wall;
      at_wall[i + 1] = distance < reach * s ? part[i + 1] : 0;
    }
    for (std::ptrdiff_t i = 0; i < n; ++i) {
      part[i + 1] += part[i];
      at_wall[i + 1] += at_wall[i];
    }
  }

  std::size_t children_of(std::size_t i) const {
    return part[i + 1] - part[i];
  }
  bool beside_wall(std::size_t i) const {
    return at_wall[i + 1] > at_wall[i];
  }
};

}  // namespace

Parts split_apart(const Blobs& blobs, const Splitting& splitting, const Shape* wall,
                  std::uint64_t step) {
  const auto n = static_cast<std::ptrdiff_t>(blobs.size());
  const double widest = splitting.sigma_max * (1 + 1e-12),
               alpha2 = splitting.alpha * splitting.alpha;
  const Places places(blobs, widest, splitting, wall);
  const Rings rings(splitting, step);
  Parts parts;
  parts.all.resize(places.part[n]);
  parts.at_wall.resize(places.at_wall[n]);
#pragma omp parallel for schedule(dynamic, 512)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const double s = blobs.sigma[i], gamma = blobs.gamma[i];
    const std::span<Part> made(&parts.all[places.part[i]], places.children_of(i));
    const bool near = places.beside_wall(i);
    std::uint32_t at_wall = near ? places.at_wall[i] : no_wall;
    const float widening = places.widening[i];
    if (made.size() == 1 && s <= widest * widening) {
      made[0] = {blobs.x[i], blobs.y[i], gamma, s * s, at_wall, widening};
      if (near) parts.at_wall[at_wall] = beside(wall->nearest(blobs.centre(i)), s);
      continue;
    }
    const Vec2 turned = s * std::sqrt(1 - alpha2) * rings.turn(gamma, s);
    for (int c = 0; c < splitting.children; ++c) {
      const Vec2 at = blobs.centre(i) + rings.child(turned, c);
      made[c] = {at.x, at.y, gamma / splitting.children, alpha2 * s * s, at_wall, widening};
      if (near) ++at_wall;
    }
    if (near)
      hold_mean(made, {&parts.at_wall[places.at_wall[i]], made.size()},
                acting_position(blobs.centre(i), s, wall), *wall);
  }
  return parts;
}

void split_wide(Blobs& blobs, const Splitting& splitting, const Shape* wall, std::uint64_t step) {
  blobs = settled(split_apart(blobs, splitting, wall, step), wall);
}

}  // namespace vortree::vortex
