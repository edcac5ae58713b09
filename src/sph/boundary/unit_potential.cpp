#include "sph/boundary/unit_potential.hpp"

#include <Eigen/LU>
#include <numbers>

#include "sph/boundary/tuning.hpp"

namespace vortree::sph {
namespace {

struct Nodes {
  std::vector<double> x, y;
  std::vector<body::WallPoint> wall;
  double step;
};

Nodes nodes_of(const body::Shape& shape, int n) {
  Nodes nodes{.x = {}, .y = {}, .wall = {}, .step = shape.perimeter() / n};
  for (int k = 0; k < n; ++k) {
    const Vec2 at = shape.point(k * nodes.step);
    nodes.x.push_back(at.x), nodes.y.push_back(at.y);
    nodes.wall.push_back(shape.nearest(at));
  }
  return nodes;
}

/// Of the velocity through the wall that sources make.
Eigen::MatrixXd through_wall(const Nodes& nodes) {
  const auto n = static_cast<Eigen::Index>(nodes.x.size());
  const double weight = nodes.step / (2 * std::numbers::pi);
  Eigen::MatrixXd matrix(n, n);
  for (Eigen::Index j = 0; j < n; ++j)
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto to = static_cast<std::size_t>(i), from = static_cast<std::size_t>(j);
      const Vec2 d{nodes.x[to] - nodes.x[from], nodes.y[to] - nodes.y[from]};
      matrix(i, j) = i == j ? 0.5 + 0.5 * weight * nodes.wall[to].curvature
                            : weight * dot(nodes.wall[to].normal, d) / dot(d, d);
    }
  return matrix;
}

}  // namespace

UnitPotentials::UnitPotentials(const body::Shape& shape, int sources) {
  const Nodes nodes = nodes_of(shape, sources);
  const Eigen::PartialPivLU<Eigen::MatrixXd> system(through_wall(nodes));
  for (const Axis axis : {along_x, along_y}) {
    Eigen::VectorXd right(sources);
    for (std::size_t k = 0; k < nodes.wall.size(); ++k) {
      const Vec2 n = nodes.wall[k].normal;
      right[static_cast<Eigen::Index>(k)] = axis == along_x ? n.x : n.y;
    }
    const Eigen::VectorXd solution = nodes.step * system.solve(right);
    const std::span<const double> q(solution.data(), nodes.x.size());
    for (std::size_t k = 0; k < q.size(); ++k) dipole_[axis] += q[k] * Vec2{nodes.x[k], nodes.y[k]};
    sources_[axis] = std::make_unique<const fmm::Plan>(
        fmm::Sources{nodes.x, nodes.y, q, {}}, fmm::Options{.tolerance = far_field_tolerance});
  }
}

/// What a source makes is what a vortex makes, turned clockwise by 90 degrees.
void UnitPotentials::gradient(Axis axis, tree::Points at, std::span<double> x,
                              std::span<double> y) const {
  sources_[axis]->velocity_bare(at, y, x);
  for (double& value : y) value = -value;
}

}  // namespace vortree::sph
