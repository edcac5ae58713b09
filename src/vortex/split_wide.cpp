#include "vortex/split_wide.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <numbers>

#include "vortex/folded_core.hpp"

namespace vortree::vortex {
namespace {

/// splitmix64 (Steele, Lea & Flood 2014): every input bit reaches every output bit.
std::uint64_t mixed(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15ull;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return z ^ (z >> 31);
}

/// About six digits: mirror images that differ by round-off still turn alike.
std::uint64_t rounded(double a) { return (std::bit_cast<std::uint64_t>(a) + (1ull << 31)) >> 32; }

double ring_angle(double gamma, double sigma, int children, std::uint64_t seed,
                  std::uint64_t step) {
  std::uint64_t hash = mixed(seed ^ mixed(step));
  hash = mixed(hash ^ rounded(std::abs(gamma)) ^ (rounded(sigma) << 32));
  const double turn = static_cast<double>(hash >> 11) * 0x1p-53;
  return std::copysign(turn * 2 * std::numbers::pi / children, gamma);
}

/// Puts the blobs from `first` on so that their mean acting position is `mean`.
void keep_mean(Blobs& blobs, std::size_t first, Vec2 mean, const Shape& wall) {
  // A second pass catches what a squeeze at the wall took up in the first.
  for (int pass = 0; pass < 3; ++pass) {
    Vec2 sum;
    for (std::size_t c = first; c < blobs.size(); ++c)
      sum = sum + acting_position(blobs.centre(c), blobs.sigma[c], &wall);
    const Vec2 shift = mean - (1.0 / static_cast<double>(blobs.size() - first)) * sum;
    for (std::size_t c = first; c < blobs.size(); ++c) {
      const Vec2 at = acting_position(blobs.centre(c), blobs.sigma[c], &wall);
      const Placed child = place(at + shift, blobs.sigma[c], &wall);
      blobs.x[c] = child.centre.x;
      blobs.y[c] = child.centre.y;
      blobs.sigma[c] = child.sigma;
    }
  }
}

Vec2 reflected_into_fluid(Vec2 at, const Shape& wall) {
  const WallPoint w = wall.nearest(at);
  return w.distance < 0 ? at - (2 * w.distance) * w.normal : at;
}

}  // namespace

void split_wide(Blobs& blobs, const Splitting& splitting, const Shape* wall, std::uint64_t step) {
  Blobs result;
  result.reserve(blobs.size());
  const int children = splitting.children;
  for (std::size_t i = 0; i < blobs.size(); ++i) {
    const Vec2 centre = blobs.centre(i);
    const double gamma = blobs.gamma[i], sigma = blobs.sigma[i];
    if (sigma <= splitting.sigma_max * (1 + 1e-12)) {
      result.append(centre, gamma, sigma);
      continue;
    }
    const double ring = sigma * std::sqrt(1 - splitting.alpha * splitting.alpha);
    const bool at_wall =
        wall && wall->nearest(centre).distance < folded::reach * sigma + ring;
    const double turned = ring_angle(gamma, sigma, children, splitting.seed, step);
    const std::size_t first = result.size();
    for (int c = 0; c < children; ++c) {
      const double phi = turned + 2 * std::numbers::pi * c / children;
      const Vec2 child = centre + ring * Vec2{std::cos(phi), std::sin(phi)};
      result.append(at_wall ? reflected_into_fluid(child, *wall) : child, gamma / children,
                    splitting.alpha * sigma);
    }
    if (at_wall) keep_mean(result, first, acting_position(centre, sigma, wall), *wall);
  }
  blobs = std::move(result);
}

}  // namespace vortree::vortex
