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

/// The normal of the wall that a particle has in its reach, or 0.
Vec2 facing(const Cloud& cloud, const body::Shape& shape, double reach, std::size_t i) {
  if (beside_wall(cloud, i)) return cloud.normal(i);
  const double near = reach * cloud.spacing[i];
  if (!cloud.free(i) || shape.beyond(cloud.at(i), near)) return {};
  const body::WallPoint wall = shape.nearest(cloud.at(i));
  return wall.distance < near ? wall.normal : Vec2{};
}

/// Particles and the walls that they face.
struct Onlookers {
  const Cloud& cloud;
  const body::Shape& shape;
  std::vector<Vec2> normal;

  /// By their normals a wall may stand between them.
  bool back_to_back(std::size_t i, std::size_t j) const {
    const Vec2 d = cloud.at(j) - cloud.at(i), n = normal[i], m = normal[j];
    return dot(d, n) < 0 && dot(d, m) > 0 && dot(n, m) < 0;
  }

  bool apart(std::size_t i, std::size_t j) const {
    // The same answer for both.
    return back_to_back(i, j) && hidden(shape, cloud.at(std::min(i, j)), cloud.at(std::max(i, j)));
  }
};

Onlookers onlookers(const Cloud& cloud, const body::Shape& shape, double reach) {
  Onlookers of{cloud, shape, std::vector<Vec2>(cloud.size())};
#pragma omp parallel for schedule(dynamic, 64)
  for (std::size_t i = 0; i < cloud.size(); ++i) of.normal[i] = facing(cloud, shape, reach, i);
  return of;
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

void keep_in_sight(tree::PairList& rows, const Cloud& cloud, const body::Shape& shape,
                   double reach) {
  const Onlookers all_of = onlookers(cloud, shape, reach);
  const std::size_t n = rows.size();
  std::vector<std::int64_t> kept(n);
  std::int64_t all = 0;
#pragma omp parallel for schedule(dynamic, 64) reduction(+ : all)
  for (std::size_t i = 0; i < n; ++i) {
    std::int32_t* const row = rows.index.data() + rows.start[i];
    std::int32_t* end = rows.index.data() + rows.start[i + 1];
    if (all_of.normal[i].x != 0 || all_of.normal[i].y != 0)
      end = std::remove_if(
          row, end, [&](std::int32_t j) { return all_of.apart(i, static_cast<std::size_t>(j)); });
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
