#include "sph/operators/sight.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace vortree::sph {
namespace {

constexpr double touching = 1e-6;  // of a segment

/// How far from one place towards another the wall is met, in steps as long as it is away.
std::optional<double> way_to_wall(const body::Shape& shape, Vec2 from, Vec2 to) {
  constexpr int most_steps = 100;
  const Vec2 d = to - from;
  const double length = std::sqrt(dot(d, d));
  double way = 0;
  for (int k = 0; k < most_steps && way < length; ++k) {
    const double free = shape.distance(from + way / length * d);
    if (free < touching * length) return way;
    way += free;
  }
  return {};
}

bool beside_wall(const Cloud& cloud, std::size_t i) {
  return cloud.kind[i] == ParticleKind::ring || cloud.kind[i] == ParticleKind::wall;
}

/// By their normals a wall may stand between them.
bool back_to_back(const Cloud& cloud, std::size_t i, std::size_t j) {
  const Vec2 d = cloud.at(j) - cloud.at(i), n = cloud.normal(i), m = cloud.normal(j);
  return dot(d, n) < 0 && dot(d, m) > 0 && dot(n, m) < 0;
}

bool apart(const Cloud& cloud, const body::Shape& shape, std::size_t i, std::size_t j) {
  if (!beside_wall(cloud, j) || !back_to_back(cloud, i, j)) return false;
  // The same answer for both.
  return hidden(shape, cloud.at(std::min(i, j)), cloud.at(std::max(i, j)));
}

}  // namespace

bool hidden(const body::Shape& shape, Vec2 from, Vec2 to) {
  const auto in = way_to_wall(shape, from, to), out = way_to_wall(shape, to, from);
  if (!in || !out) return false;
  const Vec2 d = to - from, unit = 1 / std::sqrt(dot(d, d)) * d;
  const Vec2 entered = shape.nearest(from + *in * unit).normal;
  const Vec2 left = shape.nearest(to - *out * unit).normal;
  return dot(entered, left) < 0 && dot(entered, d) < 0 && dot(left, d) > 0;
}

void keep_in_sight(tree::PairList& rows, const Cloud& cloud, const body::Shape& shape) {
  const std::size_t n = rows.size();
  std::vector<std::int64_t> kept(n);
  std::int64_t all = 0;
#pragma omp parallel for schedule(dynamic, 64) reduction(+ : all)
  for (std::size_t i = 0; i < n; ++i) {
    std::int32_t* const row = rows.index.data() + rows.start[i];
    std::int32_t* end = rows.index.data() + rows.start[i + 1];
    if (beside_wall(cloud, i))
      end = std::remove_if(row, end, [&](std::int32_t j) {
        return apart(cloud, shape, i, static_cast<std::size_t>(j));
      });
    kept[i] = end - row, all += kept[i];
  }
  if (all == rows.start[n]) return;
  std::int64_t to = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::int64_t from = std::exchange(rows.start[i], to);
    if (from != to) std::copy_n(rows.index.data() + from, kept[i], rows.index.data() + to);
    to += kept[i];
  }
  rows.start[n] = to;
}

}  // namespace vortree::sph
