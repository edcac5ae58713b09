#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "sph/pressure/sparse_rows.hpp"
#include "tree/clouds.hpp"
#include "tree/neighbors/neighbors.hpp"
#include "tree/order/sort.hpp"

namespace vortree::test {

enum class Stand { particle, wall, given };

/// Particles of the unit square that stand about as on a lattice, finer by two within a disc.
struct PressureCloud {
  std::vector<double> x, y, spacing;
  std::vector<Stand> stand;
  std::vector<std::int32_t> own;  // itself, or whose image it is

  void add(double px, double py, double s, Stand as = Stand::particle) {
    own.push_back(static_cast<std::int32_t>(x.size()));
    x.push_back(px), y.push_back(py), spacing.push_back(s), stand.push_back(as);
  }
  [[nodiscard]] std::size_t size() const { return x.size(); }
};

inline void add_parts(PressureCloud& cloud, double x, double y, double s, Chance& chance) {
  const auto jitter = [&] { return 0.2 * (chance.real() - 0.5); };
  const bool fine = std::hypot(x - 0.5, y - 0.5) < 0.25;
  for (int q = 0; q < (fine ? 4 : 1); ++q) {
    const double ox = fine ? q % 2 * 0.5 - 0.25 : 0, oy = fine ? q / 2 * 0.5 - 0.25 : 0;
    const double part = fine ? s / 2 : s;
    cloud.add(x + ox * s + jitter() * part, y + oy * s + jitter() * part, part);
  }
}

inline PressureCloud in_morton_order(const PressureCloud& cloud) {
  const tree::Points points{cloud.x, cloud.y};
  PressureCloud sorted;
  for (const auto i : tree::morton_order(points, tree::enclose(points)).index)
    sorted.add(cloud.x[i], cloud.y[i], cloud.spacing[i], cloud.stand[i]);
  return sorted;
}

/// walls   nodes all around: given pressure to the right, walls at the other sides
inline PressureCloud jittered_cloud(int side, bool walls) {
  PressureCloud cloud;
  Chance chance(7);
  const double s = 1.0 / side;
  for (int i = 0; i < side * side; ++i)
    add_parts(cloud, (i % side + 0.5) * s, (i / side + 0.5) * s, s, chance);
  for (int k = 0; walls && k < side; ++k) {
    const double t = (k + 0.5) * s;
    cloud.add(0, t, s, Stand::wall), cloud.add(1, t, s, Stand::given);
    cloud.add(t, 0, s, Stand::wall), cloud.add(t, 1, s, Stand::wall);
  }
  return in_morton_order(cloud);
}

inline constexpr double reach_of_spacing = 2.8;

/// With the images near a square that repeats, if there are no nodes around it.
inline PressureCloud with_images(const PressureCloud& cloud) {
  PressureCloud all = cloud;
  if (std::ranges::count(cloud.stand, Stand::particle) < std::ssize(cloud.stand)) return all;
  for (int image = 0; image < 9; ++image)
    for (std::size_t i = 0; i < cloud.size() && image != 4; ++i) {
      const double x = cloud.x[i] + image % 3 - 1, y = cloud.y[i] + image / 3 - 1;
      if (std::max(std::abs(x - 0.5), std::abs(y - 0.5)) > 0.5 + 8 * cloud.spacing[i]) continue;
      all.add(x, y, cloud.spacing[i]);
      all.own.back() = static_cast<std::int32_t>(i);
    }
  return all;
}

/// Weights of the Laplacian of i, times the square of its spacing: moving least squares of degree
/// two over its neighbors.
inline Eigen::VectorXd laplacian(const PressureCloud& cloud, std::size_t i,
                                 std::span<const std::int32_t> row) {
  Eigen::MatrixXd basis(row.size(), 5);
  Eigen::VectorXd weight(row.size());
  for (std::size_t k = 0; k < row.size(); ++k) {
    const auto j = static_cast<std::size_t>(row[k]);
    const double s = cloud.spacing[i], ratio = cloud.spacing[j] / s;
    const double X = (cloud.x[j] - cloud.x[i]) / s, Y = (cloud.y[j] - cloud.y[i]) / s;
    const double t = 1 - std::hypot(X, Y) / (reach_of_spacing * (1 + ratio) / 2);
    basis.row(k) << X, Y, X * X, X * Y, Y * Y;
    weight(k) = ratio * ratio * std::pow(t, 4) * (5 - 4 * t);  // Wendland C2
  }
  const Eigen::MatrixXd moments = basis.transpose() * weight.asDiagonal() * basis;
  Eigen::VectorXd wanted = Eigen::VectorXd::Zero(5);
  wanted(2) = wanted(4) = 2;
  return weight.cwiseProduct(basis * moments.ldlt().solve(wanted));
}

/// Weights of what a wall takes of the particles beside it: a fit of 1, t, n n, n t, t t without a
/// slope along the normal n.
inline Eigen::VectorXd value_at_wall(const PressureCloud& cloud, std::size_t i,
                                     std::span<const std::int32_t> row) {
  Eigen::MatrixXd basis(row.size(), 5);
  Eigen::VectorXd weight = Eigen::VectorXd::Zero(row.size());
  const bool is_upright = cloud.x[i] == 0;
  for (std::size_t k = 0; k < row.size(); ++k) {
    const auto j = static_cast<std::size_t>(row[k]);
    const double s = cloud.spacing[i], mean = (s + cloud.spacing[j]) / 2;
    const double X = (cloud.x[j] - cloud.x[i]) / s, Y = (cloud.y[j] - cloud.y[i]) / s;
    const double n = is_upright ? X : Y, t = is_upright ? Y : X;
    basis.row(k) << 1, t, n * n, n * t, t * t;
    const double q = 1 - std::hypot(n, t) * s / (reach_of_spacing * mean);
    if (cloud.stand[j] == Stand::particle) weight(k) = std::pow(q, 4) * (5 - 4 * q);
  }
  const Eigen::MatrixXd moments = basis.transpose() * weight.asDiagonal() * basis;
  const Eigen::VectorXd wanted = Eigen::VectorXd::Unit(5, 0);
  return weight.cwiseProduct(basis * moments.ldlt().solve(wanted));
}

inline tree::PairList neighbors_of(const PressureCloud& cloud) {
  std::vector<double> reach = cloud.spacing;
  for (double& r : reach) r *= reach_of_spacing;
  tree::Neighbors search;
  tree::PairList rows;
  search.place({cloud.x, cloud.y}, reach);
  search.list(tree::PairRule::mean, tree::Listing::both_ways, rows);
  return rows;
}

/// The pressure system of a cloud: Laplacians of particles, what walls take of them (diagonal -1),
/// and what is given (diagonal -1 alone).
///
/// pin   taken from the diagonals of particles, in squares of their spacings
inline sph::SparseRows pressure_rows(const PressureCloud& cloud, double pin) {
  const PressureCloud all = with_images(cloud);
  const tree::PairList pairs = neighbors_of(all);
  sph::SparseRows a;
  a.start.push_back(0);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const auto row = pairs.row(i);
    Eigen::VectorXd value = Eigen::VectorXd::Zero(row.size());
    const bool particle = cloud.stand[i] == Stand::particle;
    if (particle) value = laplacian(all, i, row);
    if (cloud.stand[i] == Stand::wall) value = value_at_wall(all, i, row);
    for (std::size_t k = 0; k < row.size() && cloud.stand[i] != Stand::given; ++k)
      a.index.push_back(all.own[static_cast<std::size_t>(row[k])]), a.value.push_back(value(k));
    a.start.push_back(static_cast<std::int32_t>(a.index.size()));
    a.diagonal.push_back(particle ? -value.sum() - pin * std::pow(cloud.spacing[i], 2) : -1);
  }
  return a;
}

/// The same in slices.
inline sph::SlicedDoubles sliced(const sph::SparseRows& a) {
  sph::SlicedDoubles made;
  made.lay_out(a.size(), [&](std::size_t i) { return 1 + a.start[i + 1] - a.start[i]; });
  std::fill_n(made.index.data(), made.index.size(), 0);
  std::fill_n(made.value.data(), made.value.size(), 0);
  constexpr std::size_t lanes = sph::SlicedDoubles::lanes;
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t to = made.begin[i / lanes] * lanes + i % lanes;
    made.index[to] = static_cast<std::int32_t>(i), made.value[to] = a.diagonal[i];
    for (std::int32_t k = a.start[i]; k < a.start[i + 1]; ++k)
      to += lanes, made.index[to] = a.index[k], made.value[to] = a.value[k];
  }
  return made;
}

/// nodes all around: walls and, to the right, given pressure.
inline sph::SparseRows walled_rows(int side) {
  return pressure_rows(jittered_cloud(side, true), 0);
}
/// a square that repeats: only the pin keeps it from being singular.
inline sph::SparseRows pinned_rows(int side) {
  return pressure_rows(jittered_cloud(side, false), 1e-5);
}

}  // namespace vortree::test
