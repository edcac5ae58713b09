#include "sph/boundary/unit_potential.hpp"

#include <Eigen/LU>
#include <numbers>

#include "sph/boundary/tuning.hpp"

namespace vortree::sph {
namespace {

struct Nodes {
  std::vector<double> x{}, y{};
  std::vector<body::WallPoint> wall{};
  std::vector<double> step{};
  std::vector<std::size_t> body{};
};

void add_curve(Nodes& nodes, const body::Shape& shape, double first, double step, int n,
               std::size_t body) {
  for (int k = 0; k < n; ++k) {
    const Vec2 at = shape.point(first + k * step);
    nodes.x.push_back(at.x), nodes.y.push_back(at.y);
    nodes.wall.push_back(shape.nearest(at));
    nodes.step.push_back(step), nodes.body.push_back(body);
  }
}

Nodes nodes_of(const body::Shape& shape, const std::vector<int>& sources) {
  Nodes nodes;
  double first = 0;
  const std::vector<double> perimeters = shape.perimeters();
  for (std::size_t body = 0; body < sources.size(); ++body) {
    const double perimeter = perimeters.at(body);
    add_curve(nodes, shape, first, perimeter / sources[body], sources[body], body);
    first += perimeter;
  }
  return nodes;
}

/// Of the velocity through the wall that sources make.
Eigen::MatrixXd through_wall(const Nodes& nodes) {
  const auto n = static_cast<Eigen::Index>(nodes.x.size());
  Eigen::MatrixXd matrix(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const auto from = static_cast<std::size_t>(j);
    const double weight = nodes.step[from] / (2 * std::numbers::pi);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto to = static_cast<std::size_t>(i);
      const Vec2 d{nodes.x[to] - nodes.x[from], nodes.y[to] - nodes.y[from]};
      matrix(i, j) = i == j ? 0.5 + 0.5 * weight * nodes.wall[to].curvature
                            : weight * dot(nodes.wall[to].normal, d) / dot(d, d);
    }
  }
  return matrix;
}

/// Of the motion of a body along x, or y.
Eigen::VectorXd through_moving(const Nodes& nodes, std::size_t body, bool along_x) {
  Eigen::VectorXd right(static_cast<Eigen::Index>(nodes.x.size()));
  for (std::size_t k = 0; k < nodes.wall.size(); ++k) {
    const Vec2 n = nodes.wall[k].normal;
    const double own = along_x ? n.x : n.y;
    right[static_cast<Eigen::Index>(k)] = nodes.body[k] == body ? own : 0;
  }
  return right;
}

}  // namespace

UnitPotentials::UnitPotentials(const body::Shape& shape, const std::vector<int>& sources)
    : of_(sources.size()) {
  const Nodes nodes = nodes_of(shape, sources);
  const Eigen::PartialPivLU<Eigen::MatrixXd> system(through_wall(nodes));
  for (std::size_t body = 0; body < sources.size(); ++body)
    for (const Axis axis : {along_x, along_y}) {
      const Eigen::VectorXd strength = system.solve(through_moving(nodes, body, axis == along_x));
      std::vector<double> q;
      Vec2& dipole = of_[body][axis].dipole;
      for (std::size_t k = 0; k < nodes.x.size(); ++k) {
        q.push_back(nodes.step[k] * strength[static_cast<Eigen::Index>(k)]);
        dipole += q[k] * Vec2{nodes.x[k], nodes.y[k]};
      }
      of_[body][axis].sources = std::make_unique<const fmm::Plan>(
          fmm::Sources{nodes.x, nodes.y, q, {}}, fmm::Options{.tolerance = far_field_tolerance});
    }
}

/// What a source makes is what a vortex makes, turned clockwise by 90 degrees.
void UnitPotentials::gradient(Axis axis, tree::Points at, std::span<double> x, std::span<double> y,
                              std::size_t body) const {
  of_[body][axis].sources->velocity_bare(at, y, x);
  for (double& value : y) value = -value;
}

}  // namespace vortree::sph
