#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "body/shapes/circle.hpp"
#include "checks/periodogram.hpp"
#include "flows.hpp"
#include "vortex/adapt/merge_close.hpp"
#include "vortex/adapt/split_wide.hpp"
#include "vortex/blobs/outflow.hpp"
#include "vortex/step.hpp"

using namespace vortree;
using vortex::Blobs;

TEST_CASE("what leaves a box is accounted for: circulation and impulse stay") {
  Blobs blobs = test::cloud(1000, 0.01, 0.02);
  const vortex::Invariants before = invariants(blobs, nullptr);
  const vortex::Box box{{-0.3, -0.4}, {0.3, 0.4}};
  const vortex::Outflow gone = account_of(take_outside(blobs, box));
  CHECK(blobs.size() < 600);
  for (std::size_t i = 0; i < blobs.size(); ++i) REQUIRE(box.holds(blobs.centre(i)));
  const vortex::Invariants after = invariants(blobs, nullptr);
  CHECK(after.circulation + gone.gamma == Approx(before.circulation).epsilon(1e-12));
  CHECK(after.moment.x + gone.moment.x == Approx(before.moment.x).epsilon(1e-12));
  CHECK(after.moment.y + gone.moment.y == Approx(before.moment.y).epsilon(1e-12));
  const Blobs inside = blobs;
  CHECK(take_outside(blobs, box).size() == 0);
  CHECK(blobs == inside);
}

TEST_CASE("what is too faint is accounted for, and all else stays as it is") {
  Blobs blobs = test::cloud(1000, 0.01, 0.02);
  for (std::size_t i = 0; i < blobs.size(); i += 3) blobs.gamma[i] *= 1e-9;
  const Blobs all = blobs;
  const double faintest = 1e-10;
  const vortex::Outflow gone = vortex::remove_faint(blobs, faintest);
  vortex::Outflow expected;
  std::size_t left = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (std::abs(all.gamma[i]) <= faintest) {
      expected = expected + vortex::Outflow{all.gamma[i], all.gamma[i] * all.centre(i)};
      continue;
    }
    REQUIRE(left < blobs.size());
    CHECK(blobs.gamma[left] == all.gamma[i]);
    CHECK(blobs.x[left++] == all.x[i]);
  }
  CHECK(left == blobs.size());
  CHECK(left < all.size());
  CHECK(gone.gamma == expected.gamma);
  // A product and a sum may be one operation here and two there: a rounding for each of those gone,
  // within places of at most 2.
  const double rounding = 0x1p-52 * 1000 * 2 * gone.of_both_signs;
  CHECK(gone.moment.x == Approx(expected.moment.x).epsilon(0).margin(rounding));
  CHECK(gone.moment.y == Approx(expected.moment.y).epsilon(0).margin(rounding));
}

TEST_CASE("a body does not notice that a vortex far behind it leaves the box") {
  const vortex::Wall wall(body::circle({}, 0.5), 60);
  const auto direct = fmm::Options{.cores = fmm::Cores::mean, .method = fmm::SumMethod::direct};
  const auto moments = [&](double edge) {
    vortex::Problem problem{.flow = {{1, 0}, 0.05},
                            .dt = 0.05,
                            .sigma_0 = 0.05,
                            .splitting = {0.2},
                            .merging = {.tolerance = 0.1, .sigma_max = 0.22},
                            .box = vortex::Box{{-99, -99}, {edge, 99}},
                            .wall = &wall,
                            .sums = direct};
    Blobs blobs;
    blobs.append({49.9, 0.5}, 0.8, 0.2);
    blobs.append({49.5, -0.5}, -0.4, 0.2);
    start(blobs, problem);
    std::vector<vortex::Wake> wakes;
    for (int k = 1; k <= 6; ++k) {
      wakes.push_back(step(blobs, problem, k, [](std::string_view) {}));
      problem.outflow = wakes.back().outflow;
      problem.drifting = wakes.back().drifting;
      problem.time += problem.dt;
      const double circulation = invariants(blobs, nullptr).circulation + problem.outflow.gamma;
      CHECK(circulation == Approx(0).margin(1e-12));
    }
    return wakes;
  };
  const auto kept = moments(99), left = moments(50);
  CHECK(kept.back().outflow.gamma == 0);
  CHECK(left.back().outflow.gamma > 0.08);  // some children of the two are still inside
  for (std::size_t k = 0; k < kept.size(); ++k) {
    // The two carry each other, by 0.1 or so of the stream: after a time of 0.3 they stand 0.03 from
    // where they drift, which the body feels, 50 away, as 0.8 * 0.03/(2 pi 50^2) = 1.5e-6. Of what
    // they carry each other, 0.03 * 0.4, the moment must have nothing.
    CHECK(left[k].moment.x == Approx(kept[k].moment.x).margin(1e-5));
    CHECK(left[k].moment.y == Approx(kept[k].moment.y).margin(1e-5));
    CHECK(left[k].pressure[0].force.x == Approx(kept[k].pressure[0].force.x).epsilon(2e-5));
  }
}

TEST_CASE("the widening lets a merger be felt at the body alike, from wherever cores widen") {
  const vortex::Coarsening coarsening{0.5};
  CHECK(coarsening.widening(0.1) == 1);
  CHECK(coarsening.widening(0.5) == 1);
  for (double d : {1.0, 5.0, 50.0}) {
    const double w = coarsening.widening(d);
    CHECK(w * std::pow(w / d, 3) == Approx(std::pow(1 / 0.5, 3)).epsilon(1e-5));
  }
  CHECK(vortex::Coarsening{}.widening(1e9) == 1);
}

TEST_CASE("beyond where cores widen, wider blobs stay whole, and more of them merge") {
  const auto wall = body::circle({}, 0.5);
  Blobs near = test::layer(3000, 1.2, 0.3, 0.02, 0.06), far = near;
  for (std::size_t i = 0; i < far.size(); ++i) {
    const double r = std::hypot(far.x[i], far.y[i]);
    far.x[i] += 30 * far.x[i] / r;
    far.y[i] += 30 * far.y[i] / r;
  }
  const vortex::Splitting splitting{.sigma_max = 0.03, .coarsening = {1}};
  const auto pieces = [&](const Blobs& blobs) {
    return split_apart(blobs, splitting, wall.get(), 1).all.size();
  };
  CHECK(pieces(far) == far.size());
  CHECK(pieces(near) > 2 * near.size());

  // A lattice of blobs merges by the same laws, whatever its scale, if the limits are as wide.
  const vortex::Merging merging{.tolerance = 0.1, .reach = 3, .sigma_max = 0.033};
  const auto left = [&](double distance, double scale) {
    Blobs blobs;
    for (int i = 0; i < 40; ++i)
      for (int j = 0; j < 40; ++j)
        blobs.append({0.5 + distance + 0.01 * scale * i, 0.01 * scale * (j - 20)},
                     1e-4 * scale * scale, 0.02 * scale);
    vortex::AdaptedBlobs adapted = split_apart(blobs, splitting, wall.get(), 1);
    merge_close(adapted, merging);
    return adapted.all.size();
  };
  CHECK(left(81, 1) < 0.3 * left(0.45, 1));
  CHECK(left(800, 1) < 10);
}

TEST_CASE("the frequency of a noisy sinusoid, to a hundredth of a bin") {
  bench::Uniform uniform(3);
  std::vector<double> samples;
  const double dt = 0.05, f = 0.1637;
  for (int i = 0; i < 1200; ++i)
    samples.push_back(2 + std::cos(2 * std::numbers::pi * f * dt * i + 1) + 0.1 * uniform());
  CHECK(checks::dominant_frequency(samples, dt) == Approx(f).margin(0.02 / (1200 * dt)));
  CHECK_THROWS_AS(checks::power_spectrum(std::vector<double>(7)), std::invalid_argument);
}
