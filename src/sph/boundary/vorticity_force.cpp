#include "sph/boundary/vorticity_force.hpp"

#include <algorithm>
#include <numeric>

#include "sph/boundary/tuning.hpp"

namespace vortree::sph {
namespace {

constexpr auto axes = {UnitPotentials::along_x, UnitPotentials::along_y};

/// So many sources that nodes of the wall stand in the middle between two.
std::vector<int> sources_for(const std::vector<int>& nodes) {
  const int all = std::accumulate(nodes.begin(), nodes.end(), 0);
  const int most = std::max(1, enough_sources / all), odd = most % 2 == 1 ? most : most - 1;
  std::vector<int> sources;
  for (const int one : nodes) sources.push_back(one * odd);
  return sources;
}

}  // namespace

VorticityForce::VorticityForce(const body::Shape& shape, const std::vector<Vec2>& wall,
                               const std::vector<int>& nodes)
    : bodies_(nodes.size()),
      dphi_ds_(nodes.size()),
      potentials_(std::make_shared<const UnitPotentials>(shape, sources_for(nodes))) {
  std::vector<double> x, y, phi_x(wall.size()), phi_y(wall.size());
  for (const Vec2 at : wall) {
    x.push_back(at.x), y.push_back(at.y);
    normal_.push_back(shape.nearest(at).normal);
  }
  const std::vector<double> perimeters = shape.perimeters();
  for (std::size_t body = 0; body < bodies_; ++body) {
    step_.insert(step_.end(), static_cast<std::size_t>(nodes[body]),
                 perimeters.at(body) / nodes[body]);
    body_.insert(body_.end(), static_cast<std::size_t>(nodes[body]), body);
    for (const auto axis : axes) {
      potentials_->gradient(axis, {x, y}, phi_x, phi_y, body);
      for (std::size_t k = 0; k < wall.size(); ++k)
        dphi_ds_[body][axis].push_back(normal_[k].x * phi_y[k] - normal_[k].y * phi_x[k]);
    }
  }
}

std::vector<Vec2> VorticityForce::on_each(const BiotSavart& far_field,
                                          const std::vector<double>& wall_vorticity, double nu,
                                          Vec2 acceleration) const {
  const BiotSavart::Vortices& vortices = far_field.vortices();
  std::vector<double> phi_x(vortices.x.size()), phi_y(vortices.x.size());
  std::vector<Vec2> forces;
  for (std::size_t body = 0; body < bodies_; ++body) {
    double along[2] = {0, 0};
    for (const auto axis : axes) {
      potentials_->gradient(axis, {vortices.x, vortices.y}, phi_x, phi_y, body);
      double sum = -dot(acceleration, potentials_->dipole(axis, body));
      for (std::size_t k = 0; k < phi_x.size(); ++k)
        sum += vortices.gamma[k] * (vortices.v[k] * phi_x[k] - vortices.u[k] * phi_y[k]);
      along[axis] = add_along_wall(sum, body, axis, wall_vorticity, nu);
    }
    forces.push_back({along[0], along[1]});
  }
  return forces;
}

double VorticityForce::add_along_wall(double sum, std::size_t body, UnitPotentials::Axis axis,
                                      const std::vector<double>& wall_vorticity, double nu) const {
  for (std::size_t k = 0; k < normal_.size(); ++k) {
    const double omega = wall_vorticity[k], step = step_[k],
                 normal = axis == UnitPotentials::along_x ? normal_[k].x : normal_[k].y,
                 n = body_[k] == body ? normal : 0;
    sum += step * omega * (step * step / 12 * omega * n - nu * dphi_ds_[body][axis][k]);
  }
  return sum;
}

}  // namespace vortree::sph
