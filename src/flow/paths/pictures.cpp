#include "flow/paths/pictures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "base/ordered_sum.hpp"
#include "tree/base/told.hpp"

namespace vortree::flow {
namespace {

using FourPictures = std::array<const VelocityPicture*, least_pictures>;
using FourWeights = std::array<double, least_pictures>;

/// Of Lagrange's cubic through four pictures, at t.
FourWeights weights_at(const FourPictures& through, double t) {
  FourWeights weights;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    weights[i] = 1;
    for (std::size_t k = 0; k < weights.size(); ++k)
      if (k != i) weights[i] *= (t - through[k]->time) / (through[i]->time - through[k]->time);
  }
  return weights;
}

Vec2 value(const FourPictures& through, const FourWeights& weights, std::size_t point) {
  Vec2 sum;
  for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * through[i]->velocity[point];
  return sum;
}

/// Two on either side of t, as far as there are.
FourPictures around(std::span<const VelocityPicture> pictures, double t) {
  const auto later = std::ranges::upper_bound(pictures, t, {}, &VelocityPicture::time);
  const std::ptrdiff_t most = std::ssize(pictures) - std::ptrdiff_t{least_pictures},
                       first = std::clamp(later - pictures.begin() - 2, std::ptrdiff_t{0}, most);
  FourPictures four;
  for (std::size_t i = 0; i < four.size(); ++i) four[i] = &pictures[first + i];
  return four;
}

void require_usable(std::span<const VelocityPicture> pictures, double t) {
  if (pictures.size() < least_pictures)
    throw std::invalid_argument(std::to_string(pictures.size()) +
                                " pictures; a cubic in time needs four");
  for (const VelocityPicture& one : pictures)
    if (one.velocity.size() != pictures[0].velocity.size())
      throw std::invalid_argument("pictures of " + std::to_string(one.velocity.size()) + " and " +
                                  std::to_string(pictures[0].velocity.size()) + " points");
  if (!(pictures.front().time <= t && t <= pictures.back().time))
    throw std::invalid_argument("t = " + tree::told(t) + " is not between the pictures of t = " +
                                tree::told(pictures.front().time) + " and " +
                                tree::told(pictures.back().time));
}

/// The polynomial that the error of a cubic goes by.
double distances(const FourPictures& through, double t) {
  double product = 1;
  for (const VelocityPicture* one : through) product *= std::abs(t - one->time);
  return product;
}

/// Sum over the points of the square of something of each.
double sum_of_squares(std::size_t points, auto of) {
  return ordered_sum(points, [&](std::size_t first, std::size_t last) {
    double sum = 0;
    for (std::size_t k = first; k < last; ++k) sum += dot(of(k), of(k));
    return sum;
  });
}

/// The relative error half-way between pictures i and i + 1.
double lost_behind(std::span<const VelocityPicture> all, std::size_t i) {
  const VelocityPicture& one = all[i];
  const FourPictures others{&all[i - 2], &all[i - 1], &all[i + 1], &all[i + 2]},
      full{&all[i - 1], &one, &all[i + 1], &all[i + 2]};
  const FourWeights weights = weights_at(others, one.time);
  const double half_way = (one.time + all[i + 1].time) / 2,
               share = distances(full, half_way) / distances(others, one.time);
  const double missed = sum_of_squares(one.velocity.size(), [&](std::size_t k) {
    return one.velocity[k] - value(others, weights, k);
  });
  const double whole =
      sum_of_squares(one.velocity.size(), [&](std::size_t k) { return one.velocity[k]; });
  return whole > 0 ? share * std::sqrt(missed / whole) : 0;
}

}  // namespace

VelocityPicture between(std::span<const VelocityPicture> pictures, double t) {
  require_usable(pictures, t);
  const FourPictures four = around(pictures, t);
  const FourWeights weights = weights_at(four, t);
  VelocityPicture made{t, std::vector<Vec2>(pictures[0].velocity.size())};
  const auto points = std::ssize(made.velocity);
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t k = 0; k < points; ++k) made.velocity[k] = value(four, weights, k);
  return made;
}

std::optional<double> lost_between(std::span<const VelocityPicture> pictures) {
  double most = 0;
  for (std::size_t i = 2; i + 2 < pictures.size(); ++i)
    most = std::max(most, lost_behind(pictures, i));
  return most > 0 ? std::optional(most) : std::nullopt;
}

}  // namespace vortree::flow
