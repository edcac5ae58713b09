#include "vortex/pressure.hpp"

#include <stdexcept>
#include <string>

#include "fmm/plan.hpp"
#include "fmm/vorticity.hpp"
#include "vortex/wall_pressure.hpp"

namespace vortree::vortex {
namespace {

/// Sums over the blobs at points, with any strengths in place of circulations.
class SumsOver {
 public:
  SumsOver(const MovingBlobs& all, tree::Points points, fmm::Options sums)
      : all_(all), at_{points.x, points.y, {}}, sums_(sums) {
    sums_.cores = fmm::Cores::source;
  }

  Velocities velocity(auto strength) const {
    Velocities u(at_.size());
    const std::vector<double> of = each(strength);
    fmm::Plan(with(of), sums_).velocity(at_, u.u, u.v);
    return u;
  }
  Gradients gradient(auto strength) const {
    Gradients g(at_.size());
    const std::vector<double> of = each(strength);
    fmm::Plan(with(of), sums_).gradient(at_, g.ux, g.uy, g.vx);
    return g;
  }
  std::vector<double> vorticity(auto strength) const {
    std::vector<double> omega(at_.size());
    const std::vector<double> of = each(strength);
    fmm::vorticity(with(of), {at_.x, at_.y}, omega, sums_.tolerance);
    return omega;
  }

 private:
  std::vector<double> each(auto strength) const {
    std::vector<double> of(all_.blobs.size());
    for (std::size_t j = 0; j < of.size(); ++j) of[j] = strength(j);
    return of;
  }
  fmm::Sources with(std::span<const double> strength) const {
    return {all_.at.x, all_.at.y, strength, all_.at.sigma};
  }

  const MovingBlobs& all_;
  fmm::Targets at_;
  fmm::Options sums_;
};

/// The dipoles gamma (v, -u). A vortex of strength q has the velocity q e x (x - x')/(2 pi r^2).
std::vector<double> of_velocities(const MovingBlobs& all, const SumsOver& sums) {
  const auto& gamma = all.blobs.gamma;
  std::vector<double> h = sums.velocity([&](std::size_t j) { return gamma[j] * all.u.v[j]; }).v;
  const Velocities of_y = sums.velocity([&](std::size_t j) { return gamma[j] * all.u.u[j]; });
  for (std::size_t k = 0; k < h.size(); ++k) h[k] += of_y.u[k];
  return h;
}

/// The quadrupoles: of a Gaussian, int omega d_k u_l dA is gamma sigma^2/2 times the mean of
/// du_l/dx_k over it. With that mean's strain e and vorticity w, and with strain E and vorticity W
/// that a unit vortex with its core has at a point,
///
///   h = -sum_j gamma_j sigma_j^2/4 (4 e_xx E_xx + 4 e_xy E_xy + w W),   e_xy = (du/dy + dv/dx)/2.
void add_slopes(std::vector<double>& h, const MovingBlobs& all, const SumsOver& sums) {
  const auto& [ux, uy, vx] = all.slope;
  const auto weight = [&](std::size_t j) {
    return -0.25 * all.blobs.gamma[j] * all.at.sigma[j] * all.at.sigma[j];
  };
  const Gradients even = sums.gradient([&](std::size_t j) { return weight(j) * 4 * ux[j]; });
  const Gradients askew = sums.gradient([&](std::size_t j) { return weight(j) * (vx[j] + uy[j]); });
  const std::vector<double> turning =
      sums.vorticity([&](std::size_t j) { return weight(j) * (vx[j] - uy[j]); });
  for (std::size_t k = 0; k < h.size(); ++k)
    h[k] += even.ux[k] + askew.vx[k] + askew.uy[k] + turning[k];
}

void require_panels(const Wall& wall, std::span<const double> values) {
  if (values.size() != wall.panels())
    throw std::invalid_argument(std::to_string(values.size()) + " values along a wall of " +
                                std::to_string(wall.panels()) + " panels");
}

/// How a body moves in the frame, and how fast it turns with it.
body::Kinematics motion_of(const Problem& p, std::size_t body, double time) {
  body::Kinematics now = p.flow.own_at(body, time);
  const body::Kinematics frame = p.flow.motion.at(time);
  now.rate += frame.rate;
  now.spin_up += frame.spin_up;
  return now;
}

/// The dipoles of the wall per unit length, as two columns.
Velocities of_wall(const Problem& p, const WallData& along) {
  const Wall& wall = *p.wall;
  const std::vector<double> pressure = integrated(wall, along.slope);
  Velocities dipoles(wall.panels());
  for (std::size_t k = 0; k < wall.rings().size(); ++k) {
    const body::Kinematics now = motion_of(p, k, p.time);
    const Ring& ring = wall.rings()[k];
    for (std::size_t i = ring.first; i < ring.end(); ++i) {
      const Vec2 x = wall.middle(i) - ring.centre, t = wall.tangent(i), n{t.y, -t.x},
                 driven = now.acceleration - 2 * now.rate * left_of(now.velocity);
      const double mu = pressure[i] + now.rate * now.rate / 2 * dot(x, x) + dot(driven, x);
      const double lambda = p.flow.nu * along.vorticity[i] - now.spin_up / 2 * dot(x, x);
      dipoles.u[i] = mu * n.x - lambda * t.x;
      dipoles.v[i] = mu * n.y - lambda * t.y;
    }
  }
  return dipoles;
}

void add_wall(std::vector<double>& h, tree::Points points, const Problem& p,
              const WallData& along) {
  fmm::Options sums = p.sums;
  sums.cores = fmm::Cores::source;
  const Velocities dipoles = of_wall(p, along);
  p.wall->add_dipoles(dipoles.u, dipoles.v, sums, points, h);
}

/// From the total head to the pressure.
void take_away_speed(std::vector<double>& h, tree::Points points, const Blobs& blobs,
                     const Problem& p) {
  const Vec2 stream = p.flow.stream_at(p.time);
  const Velocities u = velocity_at(points, blobs, p);
  for (std::size_t k = 0; k < h.size(); ++k)
    h[k] += (dot(stream, stream) - u.u[k] * u.u[k] - u.v[k] * u.v[k]) / 2;
}

}  // namespace

std::vector<double> pressure_at(tree::Points points, const Blobs& blobs, const Problem& p,
                                const WallData& along) {
  if (p.wall)
    for (const auto values : {along.slope, along.vorticity}) require_panels(*p.wall, values);
  const MovingBlobs all = moving(blobs, p, WithSlope::yes);
  const SumsOver sums(all, points, p.sums);
  std::vector<double> h = of_velocities(all, sums);
  add_slopes(h, all, sums);
  if (p.wall) add_wall(h, points, p, along);
  take_away_speed(h, points, blobs, p);
  for (std::size_t k = 0; p.wall && k < h.size(); ++k)
    if (p.wall->shape().nearest({points.x[k], points.y[k]}).distance < 0) h[k] = 0;
  return h;
}

}  // namespace vortree::vortex
