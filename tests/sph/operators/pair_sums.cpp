#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "sph/operators/clouds.hpp"
#include "sph/operators/stencils.hpp"

using namespace vortree;
using namespace vortree::sph;
using namespace vortree::sph::test;

namespace {

const OperatorOptions sums{2, 3.9, 0, nullptr, OperatorKind::pair_sums};

/// -W'(r)/r of Wendland's C4, by a difference of the kernel itself.
double kernel_slope(double r, double reach) {
  const auto kernel = [&](double at) {
    const double q = at / reach;
    return q < 1 ? 9 / (std::numbers::pi * reach * reach) * std::pow(1 - q, 6) *
                       (1 + 6 * q + 35.0 / 3 * q * q)
                 : 0;
  };
  const double h = 1e-5 * reach;
  return -(kernel(r + h) - kernel(r - h)) / (2 * h * r);
}

/// Gradient and Laplacian of a field at a particle, as the formulas say.
Eigen::Vector3d twin(const Cloud& cloud, const Stencils& stencils, std::size_t i,
                     const std::vector<double>& f) {
  Eigen::Matrix2d moment = Eigen::Matrix2d::Zero();
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double laplacian = 0;
  stencils.for_each(i, [&](std::size_t j, std::size_t slot) {
    const Vec2 at = stencils.offset(slot);
    const Eigen::Vector2d d{at.x, at.y};
    const double reach = 0.5 * sums.reach * (cloud.spacing[i] + cloud.spacing[j]);
    const double F = cloud.volume(j) * kernel_slope(d.norm(), reach);
    moment += F * d * d.transpose(), sum += F * (f[j] - f[i]) * d;
    laplacian += 2 * F * (f[j] - f[i]);
  });
  const Eigen::Vector2d gradient = moment.inverse() * sum;
  return {gradient.x(), gradient.y(), laplacian};
}

}  // namespace

TEST_CASE("pair sums are those of the formulas, and exact on linear fields") {
  const Cloud cloud = uneven_cloud(12, 4);
  Stencils stencils;
  stencils.renew(cloud, sums);
  std::vector<double> curved, linear;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    curved.push_back(std::sin(3 * cloud.x[i]) * std::cos(2 * cloud.y[i]));
    linear.push_back(1 + 2 * cloud.x[i] - 3 * cloud.y[i]);
  }
  for (std::size_t i = 0; i < cloud.size(); i += 7) {
    const Eigen::Vector3d exact = twin(cloud, stencils, i, curved);
    const double size = 1 / cloud.spacing[i];
    // Differences of the kernel err by 1e-10 of it.
    const auto of_curved = summed(stencils, curved, i), of_linear = summed(stencils, linear, i);
    CHECK(of_curved[0] == Approx(exact[0]).margin(1e-7 * size));
    CHECK(of_curved[1] == Approx(exact[1]).margin(1e-7 * size));
    CHECK(of_curved[2] + of_curved[4] == Approx(exact[2]).margin(1e-7 * size * size));
    CHECK(of_curved[3] == 0);
    CHECK(of_linear[0] == Approx(2).epsilon(1e-10));
    CHECK(of_linear[1] == Approx(-3).epsilon(1e-10));
  }
}
