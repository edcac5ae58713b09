#include "flow/initial/widths.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vortree::flow {
namespace {

std::vector<Patch> patches(const InitialSettings& initial) {
  return initial.kind->patches(initial);
}

}  // namespace

std::size_t vortices(const InitialSettings& initial) {
  return patches(initial).size();
}

Vec2 half_widths(const InitialSettings& initial) {
  return patches(initial).front().half;
}

double least_width(const InitialSettings& initial) {
  const Vec2 half = half_widths(initial);
  return std::min(half.x, half.y);
}

double mean_vorticity(const InitialSettings& initial) {
  const Patch one = patches(initial).front();
  return std::abs(one.circulation) / one.area;
}

Vec2 half_extent(const InitialSettings& initial) {
  const double widths = initial.kind->sharp ? 1 : 3;
  Vec2 farthest;
  for (const Patch& one : patches(initial)) {
    farthest.x = std::max(farthest.x, widths * one.half.x + std::abs(one.offset.x));
    farthest.y = std::max(farthest.y, widths * one.half.y + std::abs(one.offset.y));
  }
  return farthest;
}

double lattice_blobs(const InitialSettings& initial, double sigma_0) {
  const double h = initial.spacing * sigma_0, s2 = sigma_0 * sigma_0;
  const auto [a, b] = half_widths(initial);
  if (initial.kind->sharp) return std::numbers::pi * (a + h) * (b + h) / (h * h);
  const double p = std::sqrt(a * a - s2), q = std::sqrt(b * b - s2);
  return static_cast<double>(vortices(initial)) *
         (std::numbers::pi * p * q * -std::log(initial.faintest) / (h * h) + 1);
}

double vorticity(const InitialSettings& initial, Vec2 at) {
  const Vec2 centre{initial.centre[0], initial.centre[1]};
  double omega = 0;
  for (const Patch& one : patches(initial))
    omega += one.circulation / one.area * one.weight(at - centre - one.offset, 0, 0);
  return omega;
}

}  // namespace vortree::flow
