#include "sph/boundary/vorticity_force.hpp"

#include <algorithm>

#include "sph/boundary/tuning.hpp"

namespace vortree::sph {
namespace {

/// So many sources that nodes of the wall stand in the middle between two.
int sources_for(std::size_t nodes) {
  const int most = std::max(1, enough_sources / static_cast<int>(nodes));
  return static_cast<int>(nodes) * (most % 2 == 1 ? most : most - 1);
}

}  // namespace

VorticityForce::VorticityForce(const body::Shape& shape, const std::vector<Vec2>& wall)
    : step_(shape.perimeter() / static_cast<double>(wall.size())),
      potentials_(std::make_shared<const UnitPotentials>(shape, sources_for(wall.size()))) {
  std::vector<double> x, y, phi_x(wall.size()), phi_y(wall.size());
  for (const Vec2 at : wall) {
    x.push_back(at.x), y.push_back(at.y);
    normal_.push_back(shape.nearest(at).normal);
  }
  for (const auto axis : {UnitPotentials::along_x, UnitPotentials::along_y}) {
    potentials_->gradient(axis, {x, y}, phi_x, phi_y);
    for (std::size_t k = 0; k < wall.size(); ++k)
      dphi_ds_[axis].push_back(normal_[k].x * phi_y[k] - normal_[k].y * phi_x[k]);
  }
}

Vec2 VorticityForce::operator()(const BiotSavart& far_field,
                                const std::vector<double>& wall_vorticity, double nu,
                                Vec2 acceleration) const {
  const BiotSavart::Vortices& vortices = far_field.vortices();
  std::vector<double> phi_x(vortices.x.size()), phi_y(vortices.x.size());
  double along[2] = {0, 0};
  for (const auto axis : {UnitPotentials::along_x, UnitPotentials::along_y}) {
    potentials_->gradient(axis, {vortices.x, vortices.y}, phi_x, phi_y);
    double sum = -dot(acceleration, potentials_->dipole(axis));
    for (std::size_t k = 0; k < phi_x.size(); ++k)
      sum += vortices.gamma[k] * (vortices.v[k] * phi_x[k] - vortices.u[k] * phi_y[k]);
    for (std::size_t k = 0; k < normal_.size(); ++k) {
      const double omega = wall_vorticity[k],
                   n = axis == UnitPotentials::along_x ? normal_[k].x : normal_[k].y;
      sum += step_ * omega * (step_ * step_ / 12 * omega * n - nu * dphi_ds_[axis][k]);
    }
    along[axis] = sum;
  }
  return {along[0], along[1]};
}

}  // namespace vortree::sph
