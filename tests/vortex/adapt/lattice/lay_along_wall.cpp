#include "vortex/adapt/lattice/lay_along_wall.hpp"

#include <catch2/catch.hpp>
#include <numbers>

#include "body/shapes/circle.hpp"
#include "body/shapes/ellipse.hpp"
#include "vortex/adapt/split_wide.hpp"
#include "vortex/cores/folded_core.hpp"
#include "vortex/strained_flows.hpp"
#include "vortex/transport/spread_cores.hpp"

using namespace vortree;
using vortex::AdaptedBlobs;
using vortex::Blobs;
using vortex::Core;
using vortex::SpreadShares;
using vortex::WallLattice;
using vortex::WideAtWall;

namespace {

constexpr double sigma_max = 0.02, spread = sigma_max * sigma_max / 2;
const WallLattice lattice(sigma_max, spread);

struct Sums {
  double sum = 0, mean = 0, square = 0, fourth = 0;  // about the place

  Sums(double d, double V) {
    const SpreadShares share(d, V);
    for (int k = -share.reach(); k <= share.reach(); ++k) {
      const double x = k - d;
      sum += share[k];
      mean += share[k] * x;
      square += share[k] * x * x;
      fourth += share[k] * x * x * x * x;
    }
  }
};

WideAtWall wide(Vec2 at, double gamma, const Core& core, const body::Shape& wall) {
  return {at, gamma, core, wall.nearest(at)};
}

/// Blobs of either sign along a wall that the lattice takes, up to five cores from it, strained.
std::vector<WideAtWall> beside(const body::Shape& wall, std::size_t n) {
  test::Uniform uniform(3);
  std::vector<WideAtWall> blobs;
  while (blobs.size() < n) {
    const double arc = wall.perimeter() * uniform(), gamma = 2 * uniform() - 1;
    const Vec2 foot = wall.point(arc);
    const double square = sigma_max * sigma_max * (0.9 + 3 * uniform());
    const WideAtWall one = wide(foot + 5 * sigma_max * uniform() * wall.nearest(foot).normal, gamma,
                                {square, test::strain(uniform, square, 0.3)}, wall);
    if (lattice.takes(one.core, one.nearest)) blobs.push_back(one);
  }
  return blobs;
}

Blobs laid(const std::vector<WideAtWall>& blobs, const body::Shape& wall) {
  AdaptedBlobs adapted;
  lay_along_wall(adapted, blobs, lattice, wall);
  return pack(adapted, &wall);
}

Blobs as_blobs(const std::vector<WideAtWall>& wide) {
  Blobs blobs;
  for (const WideAtWall& b : wide) blobs.append(b.centre, b.gamma, b.core);
  return blobs;
}

/// Of blobs beside a wall: mean distance of what they fold, and their vorticity on it, a unit of
/// circulation.
struct Layer {
  double mean = 0, at_wall = 0;

  Layer(const Blobs& blobs, const body::Shape& wall) {
    double all = 0;
    for (std::size_t i = 0; i < blobs.size(); ++i) {
      const body::WallPoint w = wall.nearest(blobs.centre(i));
      const double s = std::sqrt(2 * blobs.core(i).covariance(w.normal).nn), y = w.distance;
      all += blobs.gamma[i];
      mean += blobs.gamma[i] * vortex::folded::mean_distance(y, s, w.curvature);
      at_wall +=
          blobs.gamma[i] * 2 * vortex::folded::inverse_sqrt_pi / s * std::exp(-y * y / s / s);
    }
    mean /= all;
    at_wall /= all;
  }
};

}  // namespace

TEST_CASE("shares of nodes in a row have the sum, the mean and the variance asked for") {
  test::Uniform uniform(1);
  for (int k = 0; k < 2000; ++k) {
    const double d = uniform() - 0.5, V = 14 * uniform() - 0.1;
    const Sums of(d, V);
    CAPTURE(d, V);
    CHECK(std::abs(of.sum - 1) < 1e-14);
    CHECK(std::abs(of.mean) < 1e-13);
    CHECK(std::abs(of.square - V) < 1e-13 * (1 + V));
  }
}

TEST_CASE("a third of a step squared is spread with the fourth moment of a Gaussian, too") {
  CHECK(std::abs(Sums(0, 1.0 / 3).fourth - 1.0 / 3) < 1e-15);
  CHECK(Sums(0, 0.25).fourth > 1.3 * 3 * 0.25 * 0.25);  // others have more or less
  for (double V : {0.6, 1.0, 3.0, 9.0})
    for (double d : {0.0, 0.3, 0.5}) {
      CAPTURE(V, d);
      // Beyond four widths a Gaussian has 0.7 % of its fourth moment.
      CHECK(std::abs(Sums(d, V).fourth / (3 * V * V) - 1) < 7e-3);
    }
}

TEST_CASE("laid along a wall blobs keep circulation and impulse to round-off") {
  const auto circle = body::circle({}, 0.5);
  const auto ellipse = body::ellipse({}, 0.5, 0.3, 0.4);
  for (const body::Shape* wall : {circle.get(), ellipse.get()}) {
    const auto blobs = beside(*wall, 2000);
    const Blobs before = as_blobs(blobs), after = laid(blobs, *wall);
    const auto was = invariants(before, wall), is = invariants(after, wall);
    // Of 2e4 shares, each of which is a whole number of units 2^-58 of all and turns by an arc
    // known to round-off.
    const double round_off = 1e-13 * test::strength(before);
    CHECK(std::abs(is.circulation - was.circulation) < round_off);
    CHECK(std::abs(is.moment.x - was.moment.x) < round_off);
    CHECK(std::abs(is.moment.y - was.moment.y) < round_off);
  }
}

TEST_CASE("the second moment of what is laid along a wall is kept to second order of the bend") {
  for (double radius : {0.5, 1.0, 2.0}) {
    const auto wall = body::circle({}, radius);
    const auto blobs = beside(*wall, 3000);
    const auto was = invariants(as_blobs(blobs), wall.get()),
               is = invariants(laid(blobs, *wall), wall.get());
    const double off = std::abs(is.second - was.second) / test::strength(as_blobs(blobs));
    CAPTURE(radius, off);
    CHECK(off < 0.1 * sigma_max * sigma_max);
  }
}

TEST_CASE("a sheet released at once spreads along a lattice as heat does, to 0.8 %") {
  const double radius = 5;  // so large that the formula for a bent wall, of first order, is exact
  const auto wall = body::circle({}, radius);
  vortex::Splitting splitting{.sigma_max = sigma_max};
  splitting.scheme = vortex::SplitScheme::lattice;
  splitting.spread = spread;
  Blobs blobs;
  for (int k = 0; k < 1400; ++k) {
    const double theta = 2 * std::numbers::pi * (k + 0.5) / 1400;
    blobs.append({radius * std::cos(theta), radius * std::sin(theta)}, 1, std::sqrt(spread / 2));
  }
  for (int step = 1; step <= 30; ++step) {
    spread_cores(blobs, 1, spread / 4, wall.get());
    split_wide(blobs, splitting, wall.get(), step);
    const double square = spread / 2 + step * spread, s = std::sqrt(square);
    const Layer layer(blobs, *wall);
    CAPTURE(step, blobs.size());
    const double mean = s * vortex::folded::inverse_sqrt_pi - square / radius / 8;
    CHECK(std::abs(layer.mean / mean - 1) < 0.008);
    if (step > 4)
      CHECK(std::abs(layer.at_wall * s / (2 * vortex::folded::inverse_sqrt_pi) - 1) < 0.01);
  }
}

TEST_CASE("a layer laid along a wall stays even along it, to the ripple of its lattice") {
  const auto wall = body::circle({}, 0.5);
  std::vector<WideAtWall> blobs;
  for (int k = 0; k < 240; ++k) {
    const double theta = 2 * std::numbers::pi * (k + 0.3) / 240;
    blobs.push_back(
        wide({0.51 * std::cos(theta), 0.51 * std::sin(theta)}, 1, {sigma_max * sigma_max}, *wall));
  }
  const Blobs nodes = laid(blobs, *wall);
  // Sums of columns.
  const auto columns = static_cast<int>(std::lround(wall->perimeter() / lattice.step));
  std::vector<double> sum(columns);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double arc = wall->nearest(nodes.centre(i)).arc / wall->perimeter();
    sum[std::lround(arc * columns) % columns] += nodes.gamma[i];
  }
  const auto [low, high] = std::ranges::minmax(sum);
  CAPTURE(low, high, columns);
  CHECK(high / low < 1.06);
}

TEST_CASE("any number of threads lays along a wall to the same bits, the mirror image nearly so") {
  const auto wall = body::circle({}, 0.5);
  const auto blobs = beside(*wall, 3000);
  const auto run = [&] { return laid(blobs, *wall); };
  const Blobs one = test::with_threads(1, run);
  CHECK(one == test::with_threads(3, run));
  std::vector<WideAtWall> mirror;
  for (const WideAtWall& b : blobs)
    mirror.push_back(wide({b.centre.x, -b.centre.y}, -b.gamma,
                          {b.core.square, {b.core.deviator.xx, -b.core.deviator.xy}}, *wall));
  CHECK(test::apart(test::mirrored(one), laid(mirror, *wall)) < 1e-12);
}

TEST_CASE("thin cores, far wider ones and sharp edges are not laid along a wall") {
  const body::WallPoint even{0, 0.01, {1, 0}, 1};
  const double s2 = sigma_max * sigma_max;
  CHECK(lattice.takes({s2}, even));
  CHECK_FALSE(lattice.takes({s2, {0.3 * s2, 0}}, even));
  CHECK_FALSE(lattice.takes({30 * s2}, even));
  CHECK_FALSE(lattice.takes({s2}, {0, 0.01, {1, 0}, 1 / sigma_max}));
  CHECK_FALSE(lattice.fits(test::FlatWall()));
}
