#include "sph/boundary/vorticity_force.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "body/shapes/circle.hpp"
#include "sph/boundary/wall_nodes.hpp"

using namespace vortree;
using namespace vortree::sph;

namespace {

constexpr double pi = std::numbers::pi, a = 0.5, nu = 0.05;

/// psi = f(r) sin(theta + turn) + g(r): a flow at rest on the circle of radius a, and far away.
///
///   f = d^2 exp(-2 d), g = d^2 exp(-3 d)/2, d = r - a;   u = dpsi/dy, v = -dpsi/dx
struct Flow {
  double turn;

  struct Radial {
    double value, slope, bend;
  };
  static Radial radial(double d, double c, double rate) {
    const double e = c * std::exp(-rate * d);
    return {d * d * e, (2 * d - rate * d * d) * e, (2 - 4 * rate * d + rate * rate * d * d) * e};
  }
  static Radial f(double r) { return radial(r - a, 1, 2); }
  static Radial g(double r) { return radial(r - a, 0.5, 3); }

  Vec2 velocity(Vec2 at) const {
    const double r = std::sqrt(dot(at, at)), theta = std::atan2(at.y, at.x) + turn;
    const double out = f(r).value * std::cos(theta) / r,
                 around = -f(r).slope * std::sin(theta) - g(r).slope;
    return (out / r) * at + (around / r) * Vec2{-at.y, at.x};
  }
  double vorticity(Vec2 at) const {
    const double r = std::sqrt(dot(at, at)), theta = std::atan2(at.y, at.x) + turn;
    const Radial one = f(r), none = g(r);
    return -(one.bend + one.slope / r - one.value / (r * r)) * std::sin(theta) - none.bend -
           none.slope / r;
  }
  /// - lap p of this velocity, by differences.
  double sink(Vec2 at) const {
    const double h = 1e-4;
    const Vec2 x = velocity(at + Vec2{h, 0}) - velocity(at - Vec2{h, 0}),
               y = velocity(at + Vec2{0, h}) - velocity(at - Vec2{0, h});
    return -2 * (x.x * y.y - y.x * x.y) / (4 * h * h);
  }
};

/// The twin: the pressure's own equation, lap p = 2 (u_x v_y - u_y v_x), dp/dn = -nu domega/ds,
/// weighted by phi = -a^2 x/r^2 or -a^2 y/r^2 itself,
///
///   F.e = -oint p n.e ds = int phi (-lap p) dA - oint phi dp/dn ds.
Vec2 by_pressure(const Flow& flow) {
  const int around = 64, out = 4000;
  const double step = 14.0 / out;
  Vec2 sum{};
  for (int k = 0; k < around; ++k) {
    const double theta = 2 * pi * k / around;
    const Vec2 n{std::cos(theta), std::sin(theta)}, t{-n.y, n.x};
    const auto phi = [&](double r) { return (-a * a / r) * n; };
    // Fields are analytic in r: Simpson's rule.
    for (int i = 0; i <= out; ++i) {
      const double r = a + i * step, weight = i == 0 || i == out ? 1 : i % 2 == 1 ? 4 : 2;
      sum += (weight * step / 3 * r * 2 * pi / around * flow.sink(r * n)) * phi(r);
    }
    const double h = 1e-4;
    const double slope = (flow.vorticity(a * n + h * t) - flow.vorticity(a * n - h * t)) / (2 * h);
    sum += (nu * slope * a * 2 * pi / around) * phi(a);
  }
  return sum;
}

struct Particles {
  Cloud cloud;
  std::vector<Slopes> slopes;
  std::vector<Vec2> wall;
  std::vector<double> wall_vorticity;

  void add(Vec2 at, double s, ParticleKind kind, const Flow& flow) {
    const std::size_t i = cloud.add(at, s, kind);
    const Vec2 u = flow.velocity(at);
    cloud.u[i] = u.x, cloud.v[i] = u.y;
    Slopes of{};
    of[1].x = flow.vorticity(at);
    slopes.push_back(of);
  }

  /// n on the wall, and rings as far apart as they are there.
  Particles(const Flow& flow, int n) {
    const double h = 2 * pi * a / n;
    for (const BoundaryNode& node : wall_nodes(*body::circle({}, a), n)) {
      add(node.at, h, ParticleKind::wall, flow);
      wall.push_back(node.at), wall_vorticity.push_back(flow.vorticity(node.at));
    }
    for (int ring = 1; ring * h < 12; ++ring)
      for (int k = 0; k < n; ++k) {
        const double r = a + ring * h, theta = 2 * pi * (k + 0.5 * (ring % 2)) / n;
        add({r * std::cos(theta), r * std::sin(theta)}, std::sqrt(h * r * 2 * pi / n),
            ParticleKind::fluid, flow);
      }
  }
};

Vec2 by_vorticity(const Flow& flow, int n, Vec2 acceleration = {}) {
  const Particles particles(flow, n);
  BiotSavart far({{-20, -20}, {20, 20}}, 1, {}, 0);
  far.renew(particles.cloud, particles.slopes, {}, {});
  return VorticityForce(*body::circle({}, a), particles.wall)(far, particles.wall_vorticity, nu,
                                                              acceleration);
}

double distance(Vec2 p, Vec2 q) {
  return std::sqrt(dot(p - q, p - q));
}

}  // namespace

TEST_CASE("The force by vorticity is that of the pressure, which is never asked for") {
  for (const double turn : {0.0, 0.7, 2.0}) {
    const Flow flow{turn};
    const Vec2 known = by_pressure(flow);
    REQUIRE(distance(known, {}) > 0.05);
    const double coarse = distance(by_vorticity(flow, 32), known),
                 fine = distance(by_vorticity(flow, 64), known);
    CAPTURE(turn, known.x, known.y, coarse, fine);
    // Fourth order, as the layer beside the wall is counted.
    CHECK(fine < 1e-3 * distance(known, {}));
    CHECK(coarse > 8 * fine);
  }
}

TEST_CASE("A frame that speeds up adds twice the displaced fluid of a circle") {
  const Flow flow{0.3};
  const Vec2 rate{0.7, -1.1}, more = by_vorticity(flow, 32, rate) - by_vorticity(flow, 32);
  CHECK(more.x == Approx(-2 * pi * a * a * rate.x).epsilon(1e-9));
  CHECK(more.y == Approx(-2 * pi * a * a * rate.y).epsilon(1e-9));
}

TEST_CASE("What has left the box still counts") {
  // A vortex that drifts with the stream far downstream: gamma (v phi_x - u phi_y).
  BiotSavart far({{-2, -2}, {4, 2}}, 0.1, {}, 0);
  far.left_x = {5}, far.left_y = {1}, far.left_gamma = {0.3};
  Cloud cloud;
  cloud.add({4, 0}, 0.1, ParticleKind::outlet);
  far.renew(cloud, std::vector<Slopes>(1), {1, 0}, {1, 0.2});
  const auto shape = body::circle({}, a);
  std::vector<Vec2> wall;
  for (const BoundaryNode& node : wall_nodes(*shape, 32)) wall.push_back(node.at);
  const Vec2 force = VorticityForce(*shape, wall)(far, std::vector<double>(32, 0.0), nu, {});
  // phi_x = Re a^2/z^2, phi_y = -Im a^2/z^2 along x; along y phi_x' = phi_y, phi_y' = -phi_x.
  const double r4 = 26 * 26, phi_x = a * a * 24 / r4, phi_y = a * a * 10 / r4;
  CHECK(force.x == Approx(0.3 * (0.2 * phi_x - phi_y)).epsilon(1e-4));
  CHECK(force.y == Approx(0.3 * (0.2 * phi_y + phi_x)).epsilon(1e-4));
}
