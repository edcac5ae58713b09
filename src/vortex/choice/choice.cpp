#include "vortex/choice/choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "body/extent.hpp"
#include "flow/initial/widths.hpp"
#include "flow/steps.hpp"
#include "vortex/choice/scales.hpp"

namespace vortree::vortex {
namespace {

/// What an accuracy calls for.
struct Choice {
  double sigma_0, sigma_max, dt, merging, reach, cap, velocity;
  int panels;
};

/// Panels no longer than what they release is wide, and fine enough where the body bends.
int panels_for(const body::BodySettings& body, double sigma_0) {
  const double perimeter = body::perimeter_of(body);
  const double around = std::max(perimeter, std::numbers::pi * body::length_of(body));
  const body::PanelLimits limits = body::panel_limits_of(body);
  const double enough = std::max(limits.panels_with(2.4 * sigma_0 * perimeter / around),
                                 enough_panels * limits.needed());
  return static_cast<int>(std::clamp(enough, 128.0, 4000.0));
}

double steps_a_period(double e) {
  return 100 * std::max(1.0, std::sqrt(0.02 / e));
}

Choice past_body(const VortexCase& scene, double e) {
  const double speed = flow::fastest_of(scene);
  const double length = body::length_of(*scene.body), nu = scene.flow.nu;
  const double reynolds = speed * length / nu;
  Choice c{};
  const double period = flow::period_of(scene);
  // Around tips strain draws cores out: with longer steps they would multiply there.
  const bool blunt = sharpest_tip(scene) > 0.1 * length;
  const double longest = 2 * e * length / speed,
               coarse = std::cbrt(std::min(e, blunt ? 0.05 : 0.01) / 0.01),
               turning = 0.02 * coarse * std::sqrt(550 / reynolds) * length / speed;
  // A scene that sets its own step has the cores that go with it.
  c.dt = scene.time.dt > 0
             ? scene.time.dt
             : flow::fitted_step(scene, std::min({longest, turning, period / steps_a_period(e),
                                                  0.1 * std::min(e, 0.05) * length * length / nu}));
  const double squares =
      blunt || e <= 0.01 ? 6 + 2 * std::min(turning / longest, 1.0) : 8 * std::sqrt(e / 0.01);
  c.sigma_max = std::min(4 * std::sqrt(e * nu * length / speed), std::sqrt(squares * nu * c.dt));
  const double beside_body = reynolds < 20 ? 4 * length * std::sqrt(e / 20) : length / 4;
  c.sigma_max = std::min({c.sigma_max, beside_body, length / 4});
  c.sigma_max = std::max(c.sigma_max, std::sqrt(4 * nu * c.dt));
  c.sigma_0 = std::min(std::sqrt(2 * nu * c.dt), c.sigma_max);
  c.merging = 4 * e * speed;
  c.reach = 3;
  c.cap = 1.2;
  c.velocity = std::clamp(e / 1000, 1e-12, 1e-3);
  c.panels = panels_for(*scene.body, c.sigma_0);
  return c;
}

Choice free_vortex(const VortexCase& scene, double e) {
  const flow::InitialSettings& i = *scene.initial;
  const double width = flow::least_width(i);
  const double omega = flow::mean_vorticity(i);
  Choice c{};
  c.sigma_max = widest_in_free_space(scene, e);
  c.sigma_0 = c.sigma_max / 1.3;
  c.dt = 0.4 / omega;
  if (scene.flow.nu > 0) c.dt = std::min(c.dt, c.sigma_max * c.sigma_max / (4 * scene.flow.nu));
  c.dt = flow::fitted_step(scene, c.dt);
  c.merging = 0.02 * e * width * omega;
  c.reach = MergingSettings{}.reach;
  c.cap = MergingSettings{}.cap;
  c.velocity = std::clamp(e / 1000, 1e-12, 1e-4);
  return c;
}

}  // namespace

void choose_missing(flow::Case& of, VortexSettings& own, const flow::Written& written) {
  if (of.initial && of.initial->kind->periodic)
    throw Refused("initial.kind",
                  fmt::format("initial.kind is \"{}\", which fills the plane; it is known to "
                              "method = \"sph\" with sph.outside = \"periodic\" only",
                              of.initial->kind->name));
  const bool body = of.body && flow::speed_of(of) > 0;
  if (of.accuracy && ((body && of.flow.nu > 0) || of.initial)) {
    const double e = *of.accuracy;
    const VortexCase scene{of, own};
    const Choice c = body ? past_body(scene, e) : free_vortex(scene, e);
    const auto fill = [&](std::string_view table, std::string_view key, auto& target,
                          const auto& value) {
      if (!written(table, key)) target = value;
    };
    fill("cores", "sigma_0", own.cores.sigma_0, c.sigma_0);
    fill("cores", "sigma_max", own.cores.sigma_max, c.sigma_max);
    fill("time", "dt", of.time.dt, c.dt);
    fill("merging", "tolerance", own.merging.tolerance, c.merging);
    fill("merging", "reach", own.merging.reach, c.reach);
    fill("merging", "cap", own.merging.cap, c.cap);
    fill("velocity", "tolerance", own.velocity.tolerance, c.velocity);
    if (body) {
      fill("body", "panels", of.body->panels, c.panels);
      for (std::size_t k = 0; k < of.others.size(); ++k)
        fill(fmt::format("body[{}]", k + 1), "panels", of.others[k].panels,
             panels_for(of.others[k], c.sigma_0));
      fill("velocity", "cores", own.velocity.cores, PairCores::both);
    }
  }
  const auto require = [&](std::string_view table, std::string_view key, double value) {
    if (value == 0)
      throw Refused(std::string(table),
                    fmt::format("[{0}] needs the key {1}, or the scene `accuracy`, which chooses "
                                "it for a body in a stream and for an initial vortex",
                                table, key));
  };
  require("cores", "sigma_0", own.cores.sigma_0);
  require("cores", "sigma_max", own.cores.sigma_max);
  require("time", "dt", of.time.dt);
}

}  // namespace vortree::vortex
