#include "vortex/adapt/lattice/spline_nodes.hpp"

#include <catch2/catch.hpp>

#include "vortex/adapt/lattice/lay_onto_lattice.hpp"
#include "vortex/strained_flows.hpp"

using namespace vortree;
using vortex::Core;
using vortex::Deviator;
using vortex::LatticeLevel;
using vortex::SplineNodes;

namespace {

const LatticeLevel level(1, 0);

/// A blob whose covariance has V more than a node's core, in steps.
Core core(double vxx, double vyy, double vxy) {
  const double h2 = level.h * level.h;
  return {level.square + h2 * (vxx + vyy), {h2 * (vxx - vyy) / 2, h2 * vxy}};
}

/// sum share x^p y^q, x and y of the nodes in steps, from the blob.
double moment(const SplineNodes& nodes, Vec2 at, int p, int q) {
  double sum = 0;
  for (int b = 0; b < SplineNodes::across; ++b)
    for (int a = 0; a < SplineNodes::across; ++a)
      sum += nodes.share[a + SplineNodes::across * b] *
             std::pow(nodes.gx + a - SplineNodes::reach - at.x / level.h, p) *
             std::pow(nodes.gy + b - SplineNodes::reach - at.y / level.h, q);
  return sum;
}

double magnitudes(const SplineNodes& nodes) {
  double sum = 0;
  for (const double share : nodes.share) sum += std::abs(share);
  return sum;
}

}  // namespace

TEST_CASE("splines keep all moments up to the third, those of a Gaussian, for any core") {
  test::Uniform uniform(3);
  for (int k = 0; k < 200; ++k) {
    const Vec2 at{10 * uniform() - 5, 10 * uniform() - 5};
    const double vxx = 1.3 * uniform() - 0.3, vyy = 1.3 * uniform() - 0.3, vxy = uniform() - 0.5;
    const SplineNodes nodes(at, core(vxx, vyy, vxy), level);
    const auto holds = [&](int p, int q, double expected) {
      CHECK(std::abs(moment(nodes, at, p, q) - expected) < 1e-12);
    };
    holds(0, 0, 1);
    holds(1, 0, 0);
    holds(0, 1, 0);
    holds(2, 0, vxx);
    holds(1, 1, vxy);
    holds(0, 2, vyy);
    for (int p = 0; p <= 3; ++p) holds(p, 3 - p, 0);
  }
}

TEST_CASE("the fourth moment along a line is 3 V^2 - 2 V + 11/30 too small, in the mean") {
  for (const double v : {0.0, 0.25, 1.0 / 3, 0.8}) {
    double mean = 0;
    constexpr int places = 64;
    for (int k = 0; k < places; ++k) {
      const Vec2 at{level.h * (k + 0.5) / places, 0};
      mean += moment(SplineNodes(at, core(v, v, 0), level), at, 4, 0) / places;
    }
    CHECK(3 * v * v - mean == Approx(3 * v * v - 2 * v + 11.0 / 30).margin(1e-3));
  }
}

TEST_CASE("of a round core no share is below -0.019, nor all of them above 1.35 without signs") {
  for (const double v : {0.25, 0.3, 1.0 / 3, 0.4, 0.5})
    for (int k = 0; k <= 20; ++k)
      for (int j = 0; j <= 20; ++j) {
        const SplineNodes nodes({0.05 * k * level.h, 0.05 * j * level.h}, core(v, v, 0), level);
        const double least = *std::ranges::min_element(nodes.share);
        CHECK(least > (v == 1.0 / 3 ? -1e-15 : -0.019));
        CHECK(magnitudes(nodes) < 1.35);
      }
}

TEST_CASE("mirror images of blobs have mirror images of shares, to the bit") {
  test::Uniform uniform(5);
  for (int k = 0; k < 100; ++k) {
    const Vec2 at{10 * uniform() - 5, 10 * uniform() - 5};
    const double v = uniform(), vxy = uniform() - 0.5;
    const SplineNodes a(at, core(v, 0.3, vxy), level), b({at.x, -at.y}, core(v, 0.3, -vxy), level);
    CHECK(a.gy == -b.gy);
    for (int row = 0; row < SplineNodes::across; ++row)
      for (int c = 0; c < SplineNodes::across; ++c)
        CHECK(a.share[c + SplineNodes::across * row] ==
              b.share[c + SplineNodes::across * (SplineNodes::across - 1 - row)]);
  }
}

TEST_CASE("laid by splines, blobs keep circulation, impulse and all second moments") {
  test::Uniform uniform(31);
  std::vector<vortex::WideBlob> wide;
  vortex::Blobs before, after;
  for (int k = 0; k < 1000; ++k) {
    const double square = level.square * (1 + uniform());
    const Core own{square, test::strain(uniform, square, 0.9)};
    const Vec2 at{40 * uniform() - 20, 40 * uniform() - 20};
    wide.push_back({at, 2 * uniform() - 1, own, 0});
    before.append(at, wide.back().gamma, own);
  }
  for (const auto& node : lay_onto_lattice(wide, 1, vortex::Shares::spline))
    after.append(node.at, node.gamma, Core{level.square});
  // Sums of terms up to 800 a blob.
  const double round_off = 1e-12 * test::strength(before);
  const test::Drift drift = test::drift(invariants(before, nullptr), invariants(after, nullptr));
  CHECK(drift.circulation < 1e-15 * test::strength(before));
  CHECK(drift.moment < round_off);
  CHECK(test::difference(test::second_moments(before), test::second_moments(after)) < round_off);
}
