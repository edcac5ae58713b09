#include "vortex/adapt/merge_close.hpp"

#include <catch2/catch.hpp>

#include "body/shapes/circle.hpp"
#include "vortex/flows.hpp"

using namespace vortree;
using vortex::Blobs;
using vortex::Merging;

namespace {

constexpr double radius = 0.5;
const Merging usual{.tolerance = 20, .sigma_max = 0.05};

Blobs merged(Blobs blobs, const Merging& merging = usual, const body::Shape* wall = nullptr) {
  merge_close(blobs, merging, wall);
  return blobs;
}

/// Two blobs on the x axis.
Blobs pair(double gamma1, double gamma2, double distance, double sigma1, double sigma2) {
  Blobs blobs;
  blobs.append({0, 0}, gamma1, sigma1);
  blobs.append({distance, 0}, gamma2, sigma2);
  return blobs;
}

/// Circulation of the blobs that turn one way.
double circulation_of(const Blobs& blobs, double sign) {
  double sum = 0;
  for (double gamma : blobs.gamma) sum += gamma * sign > 0 ? gamma : 0;
  return sum;
}

}  // namespace

TEST_CASE("merging conserves circulation, impulse and second moment to round-off in free space") {
  const Blobs blobs = test::cloud(5000, 0.02, 0.04);
  for (double tolerance : {1.0, 20.0, 1e9}) {
    const Blobs fewer = merged(blobs, {.tolerance = tolerance, .sigma_max = 0.05});
    REQUIRE(fewer.size() < 0.95 * blobs.size());
    const test::Drift drift = test::drift(invariants(blobs, nullptr), invariants(fewer, nullptr));
    CHECK(drift.circulation < 1e-14 * test::strength(blobs));
    CHECK(drift.moment < 1e-14 * test::strength(blobs));
    CHECK(drift.second < 1e-14 * test::strength(blobs));
  }
}

TEST_CASE("at a circle merging conserves circulation and sum gamma X of the folded centroids") {
  const auto wall = body::circle({}, radius);
  for (double deep : {0.0, 0.1}) {
    const Blobs blobs = test::layer(3000, radius, deep, 0.01, 0.03);
    const Blobs fewer = merged(blobs, usual, wall.get());
    REQUIRE(fewer.size() < 0.9 * blobs.size());
    const test::Drift drift =
        test::drift(invariants(blobs, wall.get()), invariants(fewer, wall.get()));
    CHECK(drift.circulation < 1e-14 * test::strength(blobs));
    CHECK(drift.moment < 1e-11 * test::strength(blobs));
  }
}

TEST_CASE("blobs of unlike sign never merge: the circulation of either sign stays") {
  const Blobs blobs = test::cloud(5000, 0.02, 0.04);
  const Blobs fewer = merged(blobs, {.tolerance = 1e9, .sigma_max = 1});
  REQUIRE(fewer.size() < blobs.size() / 4);
  for (double sign : {1.0, -1.0})
    CHECK(circulation_of(fewer, sign) == Approx(circulation_of(blobs, sign)).epsilon(1e-13));
  CHECK(merged(pair(1, -1, 0, 0.1, 0.1), {.tolerance = 1e9, .sigma_max = 1}).size() == 2);
}

TEST_CASE("a pair merges if the error that the formula gives is allowed, and not beyond") {
  const double d = 0.03, s1 = 0.05, s2 = 0.06, g1 = 2, g2 = 3;
  const double error = g1 * g2 / (g1 + g2) * (d * d + s2 * s2 - s1 * s1) / (s1 * s1 * s1);
  const Blobs two = pair(g1, g2, d, s1, s2);
  CHECK(merged(two, {.tolerance = error * 1.0001, .sigma_max = 1}).size() == 1);
  CHECK(merged(two, {.tolerance = error * 0.9999, .sigma_max = 1}).size() == 2);
  const Blobs one = merged(two, {.tolerance = error * 1.0001, .sigma_max = 1});
  CHECK(one.x[0] == Approx(0.6 * d).epsilon(1e-15));
  CHECK(one.sigma[0] == Approx(std::sqrt(0.4 * s1 * s1 + 0.6 * s2 * s2 + 0.24 * d * d)));
}

TEST_CASE("a pair merges within reach of the smaller core, and not beyond") {
  const Merging far{.tolerance = 1e9, .reach = 1.5, .sigma_max = 1};
  CHECK(merged(pair(1, 1, 1.4999 * 0.05, 0.05, 0.2), far).size() == 1);
  CHECK(merged(pair(1, 1, 1.5001 * 0.05, 0.05, 0.2), far).size() == 2);
}

TEST_CASE("no merger leaves a core wider than sigma_max, to the single precision of the choice") {
  const Blobs blobs = test::cloud(3000, 0.02, 0.04);
  for (double widest : {0.04, 0.05, 0.08}) {
    const Blobs fewer = merged(blobs, {.tolerance = 1e9, .sigma_max = widest});
    CHECK(*std::ranges::max_element(fewer.sigma) <= widest * (1 + 1e-6));
  }
}

TEST_CASE("what has merged as far as it may merges no further") {
  const Blobs once = merged(test::cloud(2000, 0.02, 0.04));
  CHECK(test::apart(once, merged(once)) == 0);
}

TEST_CASE("the mirror image of a flow merges into its mirror image") {
  const auto wall = body::circle({}, radius);
  const Blobs blobs = test::layer(2000, radius, 0.1, 0.01, 0.03);
  for (const body::Shape* shape : {wall.get(), static_cast<body::Shape*>(nullptr)}) {
    const Blobs here = merged(blobs, usual, shape);
    REQUIRE(here.size() < 0.8 * blobs.size());
    const Blobs there = test::mirrored(merged(test::mirrored(blobs), usual, shape));
    CHECK(test::apart(test::folded_there(here, shape), test::folded_there(there, shape)) < 1e-12);
  }
}

TEST_CASE("merging gives the same bits again, and for any number of threads") {
  const auto wall = body::circle({}, radius);
  const Blobs blobs = test::layer(5000, radius, 0.1, 0.01, 0.03);
  const auto run = [&] { return merged(blobs, usual, wall.get()); };
  const Blobs once = test::with_threads(1, run);
  CHECK(once == test::with_threads(1, run));
  CHECK(once == test::with_threads(2, run));
}

TEST_CASE("circulations too small for single precision merge, with each other and with big ones") {
  for (double tiny : {1e-28, 1e-35, 1e-44, 1e-60, 1e-300}) {
    Blobs blobs = test::cloud(3000, 0.02, 0.04);
    for (std::size_t i = 0; i < blobs.size(); ++i)
      if (i % 10) blobs.gamma[i] *= tiny;
    const Blobs fewer = merged(blobs);
    CHECK(fewer.size() < blobs.size() / 4);
    const test::Drift drift = test::drift(invariants(blobs, nullptr), invariants(fewer, nullptr));
    CHECK(drift.circulation < 1e-14 * test::strength(blobs));
    CHECK(drift.moment < 1e-14 * test::strength(blobs));
    CHECK(drift.second < 1e-14 * test::strength(blobs));
  }
}

TEST_CASE("blobs in one place merge into one, however many") {
  Blobs blobs;
  for (int i = 0; i < 300; ++i) blobs.append({0.1, 0.2}, 0.01, 0.03);
  const Blobs one = merged(blobs);
  REQUIRE(one.size() == 1);
  CHECK(one.x[0] == Approx(0.1).epsilon(1e-14));
  CHECK(one.y[0] == Approx(0.2).epsilon(1e-14));
  CHECK(one.gamma[0] == Approx(3).epsilon(1e-14));
  CHECK(one.sigma[0] == Approx(0.03).epsilon(1e-14));
}

TEST_CASE("a tolerance of 0 merges nothing and leaves even the order alone") {
  const Blobs blobs = test::cloud(500, 0.02, 0.04);
  CHECK(merged(blobs, {.tolerance = 0, .sigma_max = 1}) == blobs);
  CHECK(merged(Blobs{}) == Blobs{});
}

TEST_CASE("blobs merge alike in any units of length and circulation, to the last bit") {
  const Blobs blobs = test::cloud(2000, 0.02, 0.04);
  const Blobs fewer = merged(blobs);
  REQUIRE(fewer.size() < 0.95 * blobs.size());
  // Powers of two, so that nothing is rounded; some 1e-18 and 1e18 times as much.
  for (const auto& [length, circulation] : {std::pair{0x1p-60, 1.0}, std::pair{1.0, 0x1p-60},
                                            std::pair{0x1p60, 1.0}, std::pair{0x1p-30, 0x1p60}}) {
    const auto scaled = [&, length = length, circulation = circulation](Blobs some) {
      for (std::size_t i = 0; i < some.size(); ++i) {
        some.x[i] *= length;
        some.y[i] *= length;
        some.sigma[i] *= length;
        some.gamma[i] *= circulation;
        some.xx[i] *= length * length;
        some.xy[i] *= length * length;
      }
      return some;
    };
    const Merging same{.tolerance = usual.tolerance * circulation / length,
                       .sigma_max = usual.sigma_max * length};
    CHECK(merged(scaled(blobs), same) == scaled(fewer));
  }
}
