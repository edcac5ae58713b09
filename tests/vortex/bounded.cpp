#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "bench/periodogram.hpp"
#include "flows.hpp"
#include "vortex/merge_close.hpp"
#include "vortex/retire.hpp"
#include "vortex/split_wide.hpp"

using namespace vortree;
using vortex::Blobs;

TEST_CASE("what leaves a box goes on as one blob of each sign; circulation and impulse stay") {
  Blobs blobs = test::cloud(1000, 0.01, 0.02);
  const vortex::Invariants before = invariants(blobs, nullptr);
  const vortex::Box box{{-0.3, -0.4}, {0.3, 0.4}};
  std::size_t inside = 0;
  for (std::size_t i = 0; i < blobs.size(); ++i) inside += box.holds(blobs.centre(i));
  for (int again = 0; again < 2; ++again) {
    vortex::retire(blobs, box);
    CHECK(blobs.size() == inside + 2);
    const test::Drift drift = test::drift(before, invariants(blobs, nullptr));
    CHECK(drift.circulation < 1e-13);
    CHECK(drift.moment < 1e-13);
  }
  const Blobs all = test::cloud(10, 0.01, 0.02);
  blobs = all;
  vortex::retire(blobs, {{-1, -1}, {1, 1}});
  CHECK(blobs == all);
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
  const auto wall = vortex::circle({}, 0.5);
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
    vortex::Parts parts = split_apart(blobs, splitting, wall.get(), 1);
    merge_close(parts, merging);
    return parts.all.size();
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
  CHECK(bench::dominant_frequency(samples, dt) == Approx(f).margin(0.02 / (1200 * dt)));
  CHECK_THROWS_AS(bench::power_spectrum(std::vector<double>(7)), std::invalid_argument);
}
