#include "vortex/transport/convect.hpp"

#include <catch2/catch.hpp>

#include "body/shapes/circle.hpp"
#include "fmm/direct.hpp"
#include "vortex/flows.hpp"

using namespace vortree;
using flow::Scheme;
using vortex::Blobs;
using vortex::FoldedBlobs;

namespace {

constexpr double pi = std::numbers::pi;

vortex::AdvectingVelocity direct_sum(fmm::Cores cores, Vec2 stream = {}) {
  return [=](const Blobs& blobs, const FoldedBlobs& at, double, vortex::Gradients*) {
    vortex::Velocities u(blobs.size());
    velocity_direct({at.x, at.y, blobs.gamma, at.sigma}, {at.x, at.y, at.sigma}, cores, u.u, u.v);
    for (double& a : u.u) a += stream.x;
    for (double& a : u.v) a += stream.y;
    return u;
  };
}

Blobs pair(double gamma1, double gamma2, double sigma1, double sigma2) {
  Blobs blobs;
  blobs.append({-0.5, 0}, gamma1, sigma1);
  blobs.append({0.5, 0}, gamma2, sigma2);
  return blobs;
}

Blobs carried(Blobs blobs, const vortex::AdvectingVelocity& velocity, Scheme scheme, double time,
              int steps) {
  for (int k = 0; k < steps; ++k) convect(blobs, velocity, nullptr, scheme, time / steps);
  return blobs;
}

/// Two blobs one apart turn about their centre of circulation at this rate.
double turning(double gamma, double core2) {
  return gamma / (2 * pi) * -std::expm1(-1 / core2);
}

/// Where the blobs of pair(1, 2, 0.9, 1.2) have gone, less where they must be.
double pair_error(Scheme scheme, int steps) {
  const double time = 8, centre = 0.5 * (2.0 - 1.0) / 3;
  const Blobs end =
      carried(pair(1, 2, 0.9, 1.2), direct_sum(fmm::Cores::mean), scheme, time, steps);
  const double angle = time * turning(3, (0.81 + 1.44) / 2);
  const Vec2 along{std::cos(angle), std::sin(angle)};
  const Vec2 off = end.centre(1) - (Vec2{centre, 0} + (0.5 - centre) * along);
  return std::hypot(off.x, off.y);
}

}  // namespace

TEST_CASE("two blobs of unlike cores turn about each other: rk2 errs as dt^2, rk4 as dt^4") {
  CHECK(std::log2(pair_error(Scheme::rk2, 80) / pair_error(Scheme::rk2, 160)) ==
        Approx(2).margin(0.05));
  CHECK(std::log2(pair_error(Scheme::rk4, 40) / pair_error(Scheme::rk4, 80)) ==
        Approx(4).margin(0.1));
  CHECK(pair_error(Scheme::rk2, 160) < 1e-3);
  CHECK(pair_error(Scheme::rk4, 80) < 1e-6);
}

TEST_CASE("a stream alone carries blobs straight, whatever the step") {
  const Blobs blobs = test::cloud(10, 0.1, 0.2);
  const vortex::AdvectingVelocity stream = [](const Blobs& b, const FoldedBlobs&, double,
                                              vortex::Gradients*) {
    vortex::Velocities u(b.size());
    for (double& a : u.u) a = 2;
    for (double& a : u.v) a = -1;
    return u;
  };
  for (Scheme scheme : {Scheme::rk2, Scheme::rk4}) {
    const Blobs end = carried(blobs, stream, scheme, 0.5, 2);
    for (std::size_t i = 0; i < blobs.size(); ++i) {
      CHECK(end.x[i] == Approx(blobs.x[i] + 1).epsilon(1e-14));
      CHECK(end.y[i] == Approx(blobs.y[i] - 0.5).epsilon(1e-14));
    }
    CHECK(end.gamma == blobs.gamma);
    CHECK(end.sigma == blobs.sigma);
  }
}

TEST_CASE("a pair that a stream holds at rest stays, and a lone blob does not move itself") {
  // gamma and -gamma one apart travel at gamma/(2 pi) (1 - exp(-1/sigma^2)) across their line.
  const double speed = turning(1, 0.04);
  const Blobs at_rest = pair(1, -1, 0.2, 0.2);
  for (Scheme scheme : {Scheme::rk2, Scheme::rk4}) {
    const Blobs end = carried(at_rest, direct_sum(fmm::Cores::mean, {0, -speed}), scheme, 10, 50);
    CHECK(test::apart(end, at_rest) < 1e-14);
    Blobs lone;
    lone.append({0.3, 0.4}, 5, 0.1);
    CHECK(carried(lone, direct_sum(fmm::Cores::mean), scheme, 10, 5) == lone);
  }
}

TEST_CASE("mean cores conserve impulse to round-off; the sources' own do not") {
  const Blobs blobs = test::cloud(300, 0.05, 0.3);
  const auto moved = [&](fmm::Cores cores, Scheme scheme) {
    const Blobs end = carried(blobs, direct_sum(cores), scheme, 0.1, 5);
    REQUIRE(test::apart(end, blobs) > 1e-2);
    return test::drift(invariants(blobs, nullptr), invariants(end, nullptr)).moment;
  };
  for (Scheme scheme : {Scheme::rk2, Scheme::rk4})
    CHECK(moved(fmm::Cores::mean, scheme) < 1e-14 * test::strength(blobs));
  CHECK(moved(fmm::Cores::source, Scheme::rk4) > 1e-4);
}

TEST_CASE("past a wall the folded centroid is what moves, and no blob enters the body") {
  const auto wall = body::circle({}, 0.5);
  Blobs blobs;
  blobs.append({0.51, 0}, 1, 0.02);
  blobs.append({-0.505, 0}, 1, 0.02);
  const FoldedBlobs before = fold(blobs, wall.get());
  const vortex::AdvectingVelocity right = [](const Blobs& b, const FoldedBlobs&, double,
                                             vortex::Gradients*) {
    vortex::Velocities u(b.size());
    for (double& a : u.u) a = 1;
    return u;
  };
  convect(blobs, right, wall.get(), Scheme::rk2, 0.003);
  const FoldedBlobs after = fold(blobs, wall.get());
  CHECK(after.x[0] - before.x[0] == Approx(0.003).epsilon(1e-9));
  CHECK(after.x[1] - before.x[1] == Approx(0.003).epsilon(1e-9));
  CHECK(blobs.sigma[0] == 0.02);
  CHECK(blobs.sigma[1] < 0.02);  // squeezed: its mean has come nearer than sigma/sqrt(pi)
  for (int k = 0; k < 20; ++k) convect(blobs, right, wall.get(), Scheme::rk2, 0.003);
  CHECK(wall->distance(fold(blobs, wall.get()).at(1)) > 0);
  CHECK(blobs.sigma[1] > 0);
}
