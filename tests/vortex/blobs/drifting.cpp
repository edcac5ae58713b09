#include "vortex/blobs/drifting.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "body/shapes/circle.hpp"
#include "point_sets.hpp"
#include "vortex/step.hpp"
#include "vortex/tuning.hpp"

using namespace vortree;
using vortex::Blobs;
using vortex::Box;
using vortex::Drifting;

namespace {

constexpr double round_off = 2.3e-16;
const Box box{{-5, -8}, {25, 8}};

/// Vortices of both signs that have left the box on the right.
Drifting behind(int n) {
  test::Uniform uniform(5);
  Drifting all;
  for (int i = 0; i < n; ++i) {
    const double x = 25 + 100 * uniform(), y = 8 * uniform() - 4, gamma = 2 * uniform() - 1;
    all.append({x, y}, gamma, 0.1 + 0.4 * uniform(), 0);
  }
  return all;
}

/// What merging must keep, for one sign.
struct Sums {
  double gamma = 0;
  Vec2 moment;
  double second = 0, cores = 0;
};

Sums sums_of(const Drifting& all, double sign) {
  Sums sums;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (sign * all.gamma[i] <= 0) continue;
    const double gamma = all.gamma[i], square = dot(all.at(i), all.at(i));
    sums.gamma += gamma;
    sums.moment += gamma * all.at(i);
    sums.second += gamma * (square + all.sigma[i] * all.sigma[i]);
    sums.cores += gamma * (all.sigma[i] * all.sigma[i] - all.spread[i]);
  }
  return sums;
}

/// u - i v of bare vortices at a point.
Vec2 velocity(const Drifting& all, Vec2 at) {
  Vec2 u;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Vec2 d = at - all.at(i);
    u += all.gamma[i] / (2 * std::numbers::pi * dot(d, d)) * Vec2{-d.y, d.x};
  }
  return u;
}

double size_of(Vec2 a) {
  return std::hypot(a.x, a.y);
}

}  // namespace

TEST_CASE("merging of drifting vortices keeps circulation and moments of either sign") {
  const Drifting all = behind(1000);
  Drifting merged = all;
  merge_drifting(merged, 0.5, 1e-4);
  CHECK(merged.size() < 200);
  for (const double sign : {1.0, -1.0}) {
    const Sums before = sums_of(all, sign), after = sums_of(merged, sign);
    // Each of 1000 mergers rounds a few times, of sums that are at most these.
    const double most = 1000 * 10 * round_off;
    CHECK(after.gamma == Approx(before.gamma).epsilon(most));
    CHECK(after.moment.x == Approx(before.moment.x).epsilon(most));
    CHECK(after.moment.y == Approx(before.moment.y).margin(most * 4 * std::abs(before.gamma)));
    CHECK(after.second == Approx(before.second).epsilon(most));
    CHECK(after.cores == Approx(before.cores).epsilon(most * 100));  // sigma^2 less the spread
  }
}

TEST_CASE("of drifting vortices that merge the body feels what was asked for, a vortex") {
  const Drifting all = behind(1000);
  for (const double unfelt : {1e-3, 1e-4, 1e-5, 1e-6}) {
    Drifting merged = all;
    merge_drifting(merged, 0.5, unfelt);
    CAPTURE(unfelt, merged.size());
    for (int k = 0; k < 8; ++k) {
      const Vec2 at = 0.5 * Vec2{std::cos(k * std::numbers::pi / 4), std::sin(k * 0.785398)};
      const double felt = size_of(velocity(merged, at) - velocity(all, at));
      // The bound of each; the next order is smaller by a vortex's length over its distance, a
      // fourth at the most.
      CHECK(felt < 1.25 * unfelt * static_cast<double>(merged.size()));
    }
    if (unfelt < 1e-5) CHECK(merged.size() > 30);  // that it has been tried on more than two
  }
}

TEST_CASE("vortices of two signs, or of one sign and too far apart, drift by themselves") {
  Drifting pair;
  pair.append({30, 1}, 1, 0.1, 0);
  pair.append({30, 1}, -1, 0.1, 0);
  merge_drifting(pair, 0.5, 1);
  CHECK(pair.size() == 2);

  // Of 2 vortices, d apart, the body feels (1/2) d^2/(2 pi L^3): here 1e-5 at d = 1.361
  for (const double apart : {1.3, 1.4}) {
    Drifting two;
    two.append({30 - apart / 2, 0}, 1, 0.1, 0);
    two.append({30 + apart / 2, 0}, 1, 0.1, 0);
    const double felt = apart * apart / 2 / (2 * std::numbers::pi * std::pow(29.5, 3));
    merge_drifting(two, 0.5, 1e-5);
    CHECK((two.size() == 1) == (felt < 1e-5));
  }
}

TEST_CASE(
    "a drifting vortex is felt whole, then less and less, ten times as far as the box no more") {
  CHECK(felt_share({25, 8}, box) == 1);
  CHECK(felt_share({124, -39}, box) == 1);
  CHECK(felt_share({187.5, 0}, box) == Approx(0.5).epsilon(1e-14));
  CHECK(felt_share({0, -60}, box) == Approx(0.5).epsilon(1e-14));
  CHECK(felt_share({-45, 3}, box) == Approx(0.2).epsilon(1e-14));
  CHECK(felt_share({250, 0}, box) == 0);

  Drifting all;
  all.append({249, 0}, 2, 0.3, 0);
  all.append({100, 0}, 2, 0.4, 0);
  drift(all, {2, 0.5}, 0.09, box);
  REQUIRE(all.size() == 1);
  CHECK(all.x[0] == 102);
  CHECK(all.y[0] == 0.5);
  CHECK(all.sigma[0] == Approx(0.5).epsilon(1e-15));
}

TEST_CASE("in a wake without end few vortices drift") {
  // As behind a cylinder at Re = 100: 2 U D of either sign every 6 D, let go in small pieces.
  Drifting all;
  std::size_t most = 0;
  const auto pass = [&](int steps, double unfelt) {
    for (int n = 0; n < steps; ++n) {
      drift(all, {0.05, 0}, 0, box);
      const double phase = 2 * std::numbers::pi * 0.05 * n / 6;
      for (int k = 0; k < 3; ++k)
        all.append({25.0 + 0.01 * k, std::sin(phase) + 0.2 * k}, 0.018 * std::cos(phase) + 1e-9,
                   0.3, 0);
      merge_drifting(all, 0.5, unfelt);
      most = std::max(most, all.size());
    }
  };
  pass(6000, 1e-5);
  CHECK(all.x.front() < 250);
  CHECK(most < 150);
  const std::size_t late = most;
  pass(2000, 1e-5);
  CHECK(most < 1.05 * late);
  // Even if the body is to feel nothing of any merger.
  pass(300, 1e-15);
  CHECK(most <= vortex::most_drifting);
}

TEST_CASE("what comes back into the box is a blob again") {
  Drifting all;
  all.append({-5.1, 1}, 2, 0.3, 0);
  all.append({-9, 1}, 3, 0.3, 0);
  drift(all, {0.25, 0}, 0, box);
  const Blobs back = come_back(all, box);
  REQUIRE(back.size() == 1);
  CHECK(back.x[0] == Approx(-4.85).epsilon(1e-15));
  CHECK(back.gamma[0] == 2);
  REQUIRE(all.size() == 1);
  CHECK(all.gamma[0] == 3);
}

TEST_CASE("neither wall nor fluid notices the moment when vortices pass the box") {
  const vortex::Wall wall(body::circle({}, 0.5), 60);
  vortex::Problem problem{.flow = {{1, 0}, 0.05},
                          .dt = 0.05,
                          .sigma_0 = 0.05,
                          .splitting = {0.2},
                          .merging = {},
                          .box = box,
                          .wall = &wall,
                          .sums = {.cores = fmm::Cores::mean, .method = fmm::SumMethod::direct}};
  Blobs blobs;
  blobs.append({25.01, 0.3}, 0.7, 0.3);
  blobs.append({24.99, -0.3}, -0.4, 0.3);
  blobs.append({3, -8.02}, 0.2, 0.2);
  const std::vector<double> x{0, 0.6, 24, 25, 2}, y{0.5, 0, 0.1, 0.2, -7.9};
  const vortex::Velocities kept = velocity_at({x, y}, blobs, problem);
  const Blobs left = take_outside(blobs, box);
  REQUIRE(left.size() == 2);
  problem.outflow = account_of(left);
  take(problem.drifting, left);
  const vortex::Velocities passed = velocity_at({x, y}, blobs, problem);
  for (std::size_t k = 0; k < x.size(); ++k) {
    // The same sums in another order: 63 vortices, and a sheet of condition 10 or so.
    CHECK(passed.u[k] == Approx(kept.u[k]).margin(1000 * round_off));
    CHECK(passed.v[k] == Approx(kept.v[k]).margin(1000 * round_off));
  }
}
