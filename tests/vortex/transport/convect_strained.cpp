#include "vortex/transport/convect_strained.hpp"

#include <catch2/catch.hpp>

#include "fmm/plan.hpp"
#include "vortex/blobs/energy.hpp"
#include "vortex/strained_flows.hpp"

using namespace vortree;
using flow::Scheme;
using vortex::Blobs;
using vortex::Gradients;
using vortex::Velocities;

namespace {

/// The mean over both cores, all pairs summed.
Velocities of_both_cores(const Blobs& parts, double, Gradients& g) {
  std::vector<double> sigma = parts.sigma;
  for (double& s : sigma) s *= std::numbers::sqrt2;
  const fmm::Plan plan({parts.x, parts.y, parts.gamma, sigma},
                       {.cores = fmm::Cores::mean, .method = fmm::SumMethod::direct});
  Velocities u(parts.size());
  g = Gradients(parts.size());
  plan.velocity_and_gradient(u.u, u.v, g.ux, g.uy, g.vx);
  return u;
}

/// u = G x, everywhere.
vortex::PartsVelocity linear(double ux, double uy, double vx) {
  return [=](const Blobs& parts, double, Gradients& g) {
    Velocities u(parts.size());
    g = Gradients(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
      u.u[i] = ux * parts.x[i] + uy * parts.y[i];
      u.v[i] = vx * parts.x[i] - ux * parts.y[i];
      g.ux[i] = ux;
      g.uy[i] = uy;
      g.vx[i] = vx;
    }
    return u;
  };
}

Blobs after(Blobs blobs, const vortex::PartsVelocity& velocity, Scheme scheme, double time,
            int steps) {
  for (int k = 0; k < steps; ++k) convect_strained(blobs, velocity, scheme, time / steps);
  return blobs;
}

/// Blobs that overlap and are long already.
Blobs start() {
  Blobs blobs = test::strained(test::cloud(40, 0.1, 0.2), 0.7);
  for (double& gamma : blobs.gamma) gamma = std::abs(gamma);
  return blobs;
}

double largest_difference(const Blobs& a, const Blobs& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    most = std::max({most, std::abs(a.x[i] - b.x[i]), std::abs(a.y[i] - b.y[i]),
                     std::abs(a.core(i).square - b.core(i).square), std::abs(a.xx[i] - b.xx[i]),
                     std::abs(a.xy[i] - b.xy[i])});
  return most;
}

}  // namespace

TEST_CASE("in a flow of constant gradient cores become F V F^T, F = exp(G t)") {
  const vortex::Gradient g{0.3, -0.9, 0.4};
  const Blobs blobs = test::strained(test::cloud(50, 0.05, 0.2), 0.6);
  const Blobs end = after(blobs, linear(g.ux, g.uy, g.vx), Scheme::rk4, 1, 50);
  for (std::size_t i = 0; i < blobs.size(); ++i) {
    const vortex::Core exact = carried(blobs.core(i), g, 1), found = end.core(i);
    CHECK(std::abs(found.square - exact.square) < 1e-6 * exact.square);
    CHECK((found.deviator - exact.deviator).size() < 1e-6 * exact.square);
  }
}

TEST_CASE("strained free blobs keep circulation and impulse, and, as steps shrink, the rest") {
  const Blobs blobs = start();
  const vortex::Invariants before = invariants(blobs, nullptr);
  const double energy = vortex::energy(blobs).energy;
  double last_second = 0;
  for (const int steps : {10, 20}) {
    const Blobs end = after(blobs, of_both_cores, Scheme::rk4, 0.1, steps);
    const test::Drift drift = test::drift(before, invariants(end, nullptr));
    CHECK(drift.circulation == 0);
    CHECK(drift.moment < 1e-13 * test::strength(blobs));
    if (steps == 20) {
      CHECK(drift.second < last_second / 12);  // 16
      // What rates of short halves are blended with, short_way.
      CHECK(vortex::energy(end).energy == Approx(energy).epsilon(1e-6));
    }
    last_second = drift.second;
  }
}

TEST_CASE("strained cores: rk2 errs as dt^2, rk4 as dt^4") {
  const Blobs exact = after(start(), of_both_cores, Scheme::rk4, 0.2, 160);
  const auto error = [&](Scheme scheme, int steps) {
    return largest_difference(after(start(), of_both_cores, scheme, 0.2, steps), exact);
  };
  CHECK(std::log2(error(Scheme::rk2, 20) / error(Scheme::rk2, 40)) == Approx(2).margin(0.2));
  CHECK(std::log2(error(Scheme::rk4, 10) / error(Scheme::rk4, 20)) == Approx(4).margin(0.4));
}
