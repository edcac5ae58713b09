#include "vortex/stream_function.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

#include "body/shapes/circle.hpp"
#include "body/shapes/ellipse.hpp"
#include "exact/lamb_oseen.hpp"
#include "vortex/cylinder_flow.hpp"
#include "vortex/flows.hpp"
#include "vortex/solver.hpp"

using namespace vortree;
using vortex::Blobs;
using vortex::Problem;
using vortex::Turning;
using vortex::Wall;

namespace {

const double pi = std::numbers::pi, radius = 0.5;

struct Places {
  std::vector<double> x, y;

  void add(Vec2 at) { x.push_back(at.x), y.push_back(at.y); }
  tree::Points points() const { return {x, y}; }
  std::size_t size() const { return x.size(); }
  Vec2 at(std::size_t k) const { return {x[k], y[k]}; }
};

/// Around the circle, so many panels from the wall, at all places along them.
Places ring(double distance) {
  Places places;
  for (int k = 0; k < 499; ++k) {
    const double angle = 2 * pi * (k + 0.37) / 499;
    places.add({(radius + distance) * std::cos(angle), (radius + distance) * std::sin(angle)});
  }
  return places;
}

Problem past(const Wall& wall, Vec2 stream) {
  return {.flow = {stream, 0.01},
          .dt = 0.02,
          .sigma_0 = 0.02,
          .splitting = {},
          .merging = {},
          .wall = &wall,
          .sums = {.tolerance = 1e-8}};
}

/// The largest error of the stream past the circle, u = 1 far away, so many panels from the wall.
double error_of_stream(int panels, double lengths) {
  const Wall wall(body::circle({}, radius), panels);
  const Places at = ring(lengths * wall.panel_length(0));
  const std::vector<double> psi = stream_function_at(at.points(), {}, past(wall, {1, 0}));
  double largest = 0;
  for (std::size_t k = 0; k < at.size(); ++k) {
    const double r2 = dot(at.at(k), at.at(k));
    largest = std::max(largest, std::abs(psi[k] - at.y[k] * (1 - radius * radius / r2)));
  }
  return largest;
}

/// Flux from one point to another to the left of the way, int u dy - v dx, by Simpson's rule.
double flux(const std::function<vortex::Velocities(tree::Points)>& velocity, Vec2 from, Vec2 to,
            int intervals) {
  Places at;
  for (int k = 0; k <= intervals; ++k)
    at.add(from + (static_cast<double>(k) / intervals) * (to - from));
  const vortex::Velocities u = velocity(at.points());
  double sum = 0;
  for (int k = 0; k <= intervals; ++k) {
    const double weight = k == 0 || k == intervals ? 1 : k % 2 ? 4 : 2;
    sum += weight * (u.u[k] * (to.y - from.y) - u.v[k] * (to.x - from.x));
  }
  return sum / (3 * intervals);
}

/// A problem of an ellipse that turns about a pivot and moves on, in a stream.
struct TurningEllipse {
  Wall wall;
  Turning turning;
  Problem problem;

  explicit TurningEllipse(int panels)
      : wall(body::ellipse({0.3, -0.1}, 0.5, 0.25, 0), panels),
        turning(wall),
        problem(past(wall, {0.8, 0.3})) {
    problem.flow.motion = {.spin = {1.7}};
    problem.turning = {&turning, 1};
  }
};

}  // namespace

TEST_CASE("the stream function past a circle is U y (1 - R^2/r^2)") {
  for (const double lengths : {4.0, 30.0, 300.0}) CHECK(error_of_stream(128, lengths) < 2e-6);
  for (const double lengths : {0.0, 0.01, 0.5, 1.0, 2.9}) {
    CAPTURE(lengths);
    const double coarse = error_of_stream(64, lengths), fine = error_of_stream(128, lengths);
    CHECK(fine < 2e-4);
    CHECK(fine < coarse / 3);
  }
}

TEST_CASE("the near field of a sheet goes over into that of vortices with a step of third order") {
  const auto exact = [](Vec2 at) { return at.y * (1 - radius * radius / dot(at, at)); };
  const auto step = [&](int panels) {
    const Wall wall(body::circle({}, radius), panels);
    const double b = wall.panel_length(0);
    const Places within = ring(2.9999 * b), beyond = ring(3.0001 * b);
    const auto a = stream_function_at(within.points(), {}, past(wall, {1, 0})),
               c = stream_function_at(beyond.points(), {}, past(wall, {1, 0}));
    double largest = 0;
    for (std::size_t k = 0; k < a.size(); ++k)
      largest =
          std::max(largest, std::abs(c[k] - a[k] - exact(beyond.at(k)) + exact(within.at(k))));
    return largest;
  };
  CHECK(step(128) <
        std::pow(2 * pi * radius / 128, 3));  // without the share of the ends 5 times that
  CHECK(step(128) < step(64) / 6);
}

TEST_CASE("within a body at rest, and on its wall, the stream function is 0") {
  const Wall wall(body::circle({}, radius), 128);
  Places at;
  for (const double r : {0.0, 0.2, 0.49}) at.add({r * std::cos(1 + r), r * std::sin(1 + r)});
  const Blobs blobs = test::layer(200, radius, 0.3, 0.01, 0.05);
  for (const double psi : stream_function_at(at.points(), blobs, past(wall, {1, 0.5})))
    CHECK(psi == 0);
}

TEST_CASE("the stream function of a vortex beside a circle in fluid at rest is by its image") {
  const test::Complex z0 = std::polar(0.8, 2.0), image = radius * radius / std::conj(z0);
  const auto error = [&](int panels) {
    const Wall wall(body::circle({}, radius), panels);
    Blobs blobs;
    blobs.append(test::vec2(z0), 1.0, 0.01);
    double largest = 0;
    for (const double lengths : {0.0, 0.3, 5.0, 400.0}) {
      const Places at = ring(lengths * wall.panel_length(0));
      const auto psi = stream_function_at(at.points(), blobs, past(wall, {}));
      for (std::size_t k = 0; k < at.size(); ++k) {
        const test::Complex z = test::complex(at.at(k));
        const double exact =
            std::log(std::abs(z - image) / std::abs(z - z0) * std::abs(z0) / radius) / (2 * pi);
        largest = std::max(largest, std::abs(psi[k] - exact));
      }
    }
    return largest;
  };
  CHECK(error(128) < 1e-3);
  CHECK(error(128) < error(64) / 3);
}

TEST_CASE("slopes of the stream function of a vortex in a stream are its velocity") {
  const exact::LambOseen oseen{1.0, 0.2, 1e-3};
  Blobs blobs;
  blobs.append({0, 0}, 1.0, 0.2);
  const Problem problem{.flow = {{0.4, -0.3}, 1e-3},
                        .dt = 0.02,
                        .sigma_0 = 0.04,
                        .splitting = {},
                        .merging = {},
                        .sums = {.tolerance = 1e-10}};
  constexpr double h = 1e-3;
  for (const double r : {0.01, 0.1, 0.3, 2.0}) {
    const Vec2 at{r * std::cos(4 * r), r * std::sin(4 * r)};
    Places around;
    for (const double step : {-2.0, -1.0, 1.0, 2.0}) around.add(at + Vec2{0, step * h});
    for (const double step : {-2.0, -1.0, 1.0, 2.0}) around.add(at + Vec2{step * h, 0});
    const auto psi = stream_function_at(around.points(), blobs, problem);
    const auto slope = [&](std::size_t k) {
      return (psi[k] - psi[k + 3] + 8 * (psi[k + 2] - psi[k + 1])) / (12 * h);
    };
    const double swirl = oseen.swirl(r, 0) / r;
    CHECK(slope(0) == Approx(0.4 - swirl * at.y).margin(1e-7));
    CHECK(-slope(4) == Approx(-0.3 + swirl * at.x).margin(1e-7));
  }
}

TEST_CASE("differences of the stream function are the flux of the velocity, whatever moves") {
  TurningEllipse flow(160);
  Blobs blobs;
  test::Uniform uniform(5);
  for (int k = 0; k < 100; ++k) {
    const double angle = 2 * pi * uniform(), out = 1.02 + 0.6 * uniform();
    blobs.append({0.3 + 0.5 * out * std::cos(angle), -0.1 + 0.25 * out * std::sin(angle)},
                 0.1 * uniform() - 0.04, 0.03 + 0.03 * uniform());
  }
  const auto velocity = [&](tree::Points at) { return velocity_at(at, blobs, flow.problem); };
  const auto psi = [&](Vec2 from, Vec2 to) {
    Places both;
    both.add(from), both.add(to);
    const auto values = stream_function_at(both.points(), blobs, flow.problem);
    return values[1] - values[0];
  };
  const Vec2 corners[] = {{1.2, -0.8}, {1.3, 0.7}, {-0.7, 0.6}, {-0.6, -0.9}};
  double all = 0;
  for (int k = 0; k < 4; ++k) {
    const Vec2 from = corners[k], to = corners[(k + 1) % 4];
    CHECK(psi(from, to) == Approx(flux(velocity, from, to, 400)).margin(1e-6));
    all += flux(velocity, from, to, 400);
  }
  CHECK(all == Approx(0).margin(1e-6));
  // From the wall out, through the panels.
  for (const Vec2 wall : {Vec2{0.8, -0.1}, Vec2{0.3, 0.15}, Vec2{0.3, -0.35}}) {
    const Vec2 out = wall + 1.5 * (wall - Vec2{0.3, -0.1});
    const Vec2 off = wall + 1e-9 * (out - wall);
    CHECK(psi(off, out) == Approx(flux(velocity, off, out, 2000)).margin(4e-4));
  }
}

TEST_CASE("a wall that turns has the stream function of its own motion, and the fluid goes on") {
  for (const int panels : {100, 200}) {
    const TurningEllipse flow(panels);
    Places off;
    double mean = 0;
    for (std::size_t i = 0; i < flow.wall.panels(); ++i) {
      const Vec2 at = flow.wall.middle(i);
      off.add(at + 1e-9 * flow.wall.shape().nearest(at).normal);
      mean += dot(at, at) / static_cast<double>(flow.wall.panels());
    }
    const auto psi = stream_function_at(off.points(), {}, flow.problem);
    double most = 0;
    for (std::size_t i = 0; i < psi.size(); ++i)
      most = std::max(most, std::abs(psi[i] + 1.7 / 2 * (dot(off.at(i), off.at(i)) - mean)));
    CHECK(most < (panels == 100 ? 4e-3 : 1e-3));
    Places within;
    within.add({0.4, -0.05});
    CHECK(stream_function_at(within.points(), {}, flow.problem)[0] ==
          Approx(-1.7 / 2 * (0.4 * 0.4 + 0.05 * 0.05 - mean)));
  }
}

TEST_CASE("the stream function of a flow that drifts is that of the velocity it samples") {
  vortex::Setup setup{.problem = {.flow = {{}, 1e-3},
                                  .dt = 0.02,
                                  .sigma_0 = 0.1,
                                  .splitting = {.sigma_max = 0.2},
                                  .merging = {.tolerance = 0.01, .sigma_max = 0.22},
                                  .sums = {.tolerance = 1e-8}},
                      .origin = {{3, 4}, {0.7, -0.2}}};
  setup.blobs.append({0.1, 0}, 1, 0.1);
  setup.blobs.append({-0.1, 0}, -0.6, 0.1);
  vortex::VortexSolver solver(std::move(setup));
  for (int k = 0; k < 3; ++k) solver.step([](std::string_view) {});
  const auto velocity = [&](tree::Points at) {
    flow::Samples found = solver.sample(at);
    vortex::Velocities u;
    u.u = std::move(found.u), u.v = std::move(found.v);
    return u;
  };
  Places both;
  both.add({2.8, 3.9}), both.add({3.5, 4.2});
  const auto psi = solver.stream_function(both.points());
  CHECK(psi[1] - psi[0] == Approx(flux(velocity, both.at(0), both.at(1), 400)).margin(1e-6));
}
