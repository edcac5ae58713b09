#include "checks/spin.hpp"

#include <cmath>
#include <numbers>

#include "body/extent.hpp"
#include "exact/spinning_cylinder.hpp"

namespace vortree::checks {

void check_spin(std::vector<Verdict>& list, const Finished& run) {
  const io::Scene& scene = run.scene;
  const io::CheckSettings& c = scene.check;
  if (c.exact != io::ExactAnswer::spinning_cylinder) return;
  constexpr int rays = 7, places = 60;
  const exact::SpinningCylinder cylinder{scene.motion->spin, body::length_of(*scene.body) / 2,
                                         scene.flow.nu};
  const double t = run.solver.time(), layer = std::sqrt(cylinder.nu * t);
  const auto [x0, y0] = scene.body->centre;
  Series x, y, swirl, vorticity;
  for (int i = 1; i <= places; ++i) {
    const double r = cylinder.radius + 0.1 * i * layer;
    for (int k = 0; k < rays; ++k) {
      const double angle = 0.3 + 2 * std::numbers::pi * k / rays;
      x.push_back(x0 + r * std::cos(angle));
      y.push_back(y0 + r * std::sin(angle));
    }
    swirl.push_back(cylinder.swirl(r, t));
    vorticity.push_back(cylinder.vorticity(r, t));
  }
  const flow::Samples found = run.solver.sample({x, y});
  Series velocity_off, vorticity_off;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double r = std::hypot(x[k] - x0, y[k] - y0), u = swirl[k / rays] / r;
    velocity_off.push_back(std::hypot(found.u[k] + u * (y[k] - y0), found.v[k] - u * (x[k] - x0)));
    vorticity_off.push_back(found.omega[k] - vorticity[k / rays]);
  }
  add(list, "velocity_max", c.velocity_max, [&] {
    return Reached{share(largest_of(velocity_off), std::abs(cylinder.rate) * cylinder.radius)};
  });
  add(list, "vorticity_max", c.vorticity_max, [&] {
    return Reached{
        share(largest_of(vorticity_off), std::abs(cylinder.vorticity(cylinder.radius, t)))};
  });
}

}  // namespace vortree::checks
