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
std::uint64_t rounded(double a) {
  return (std::bit_cast<std::uint64_t>(a) + (1ull << 31)) >> 32;
}

double ring_angle(double gamma, double sigma, int children, std::uint64_t seed,
                  std::uint64_t step) {
  std::uint64_t hash = mixed(seed ^ mixed(step));
  hash = mixed(hash ^ rounded(std::abs(gamma)) ^ (rounded(sigma) << 32));
  const double turn = static_cast<double>(hash >> 11) * 0x1p-53;
  return std::copysign(turn * 2 * std::numbers::pi / children, gamma);
}

/// Moves the blobs of a range together so that their mean acting position is `mean`.
void keep_mean(Blobs& blobs, std::size_t first, std::size_t last, Vec2 mean, const Shape& wall) {
  // Further passes catch what a squeeze at the wall took up in the first.
  for (int pass = 0; pass < 3; ++pass) {
    Vec2 sum;
    for (std::size_t c = first; c < last; ++c)
      sum = sum + acting_position(blobs.centre(c), blobs.sigma[c], &wall);
    const Vec2 shift = mean - (1.0 / static_cast<double>(last - first)) * sum;
    for (std::size_t c = first; c < last; ++c) {
      const Vec2 at = acting_position(blobs.centre(c), blobs.sigma[c], &wall);
      const Placed child = place(at + shift, blobs.sigma[c], &wall);
      blobs.put(c, child.centre, blobs.gamma[c], child.sigma);
    }
  }
}

Vec2 reflected_into_fluid(Vec2 at, const Shape& wall) {
  const WallPoint w = wall.nearest(at);
  return w.distance < 0 ? at - (2 * w.distance) * w.normal : at;
}

/// Writes the children of a blob from `first` on.
void split(Blobs& result, std::size_t first, Vec2 centre, double gamma, double sigma,
           const Splitting& splitting, const Shape* wall, std::uint64_t step) {
  const int children = splitting.children;
  const double ring = sigma * std::sqrt(1 - splitting.alpha * splitting.alpha);
  const bool at_wall = wall && wall->nearest(centre).distance < folded::reach * sigma + ring;
  const double turned = ring_angle(gamma, sigma, children, splitting.seed, step);
  for (int c = 0; c < children; ++c) {
    const double phi = turned + 2 * std::numbers::pi * c / children;
    const Vec2 child = centre + ring * Vec2{std::cos(phi), std::sin(phi)};
    result.put(first + c, at_wall ? reflected_into_fluid(child, *wall) : child, gamma / children,
               splitting.alpha * sigma);
  }
  if (at_wall)
    keep_mean(result, first, first + children, acting_position(centre, sigma, wall), *wall);
}

}  // namespace

void split_wide(Blobs& blobs, const Splitting& splitting, const Shape* wall, std::uint64_t step) {
  const auto n = static_cast<std::ptrdiff_t>(blobs.size());
  const double widest = splitting.sigma_max * (1 + 1e-12);
  std::vector<std::size_t> first(n + 1);
  for (std::ptrdiff_t i = 0; i < n; ++i)
    first[i + 1] = first[i] + (blobs.sigma[i] > widest ? splitting.children : 1);
  if (first[n] == blobs.size()) return;
  Blobs result;
  result.resize(first[n]);
#pragma omp parallel for schedule(dynamic, 256)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    if (blobs.sigma[i] > widest)
      split(result, first[i], blobs.centre(i), blobs.gamma[i], blobs.sigma[i], splitting, wall,
            step);
    else
      result.put(first[i], blobs.centre(i), blobs.gamma[i], blobs.sigma[i]);
  }
  blobs = std::move(result);
}

}  // namespace vortree::vortex
