#include "vortex/adapt/split_wide.hpp"

#include <catch2/catch.hpp>

#include "body/shapes/circle.hpp"
#include "vortex/flows.hpp"

using namespace vortree;
using vortex::Blobs;
using vortex::Splitting;

namespace {

constexpr double radius = 0.5;

Blobs halves(Blobs blobs, const Splitting& splitting, const body::Shape* wall,
             std::uint64_t step = 3) {
  split_wide(blobs, splitting, wall, step);
  return blobs;
}

double widest(const Blobs& blobs) {
  return *std::ranges::max_element(blobs.sigma);
}

/// The deepest that a centre lies in the body.
double depth(const Blobs& blobs, const body::Shape& wall) {
  double deepest = 0;
  for (std::size_t i = 0; i < blobs.size(); ++i)
    deepest = std::max(deepest, -wall.nearest(blobs.centre(i)).distance);
  return deepest;
}

}  // namespace

TEST_CASE("splitting conserves circulation, impulse and second moment to round-off in free space") {
  const Blobs blobs = test::cloud(1000, 0.05, 0.2);
  const double round_off = 1e-14 * test::strength(blobs);
  for (double alpha : {0.5, 0.7, 0.9}) {
    for (int children : {4, 6}) {
      const Blobs split = halves(blobs, {0.1, alpha, children}, nullptr);
      REQUIRE(split.size() > 2 * blobs.size());
      const test::Drift drift = test::drift(invariants(blobs, nullptr), invariants(split, nullptr));
      CHECK(drift.circulation < round_off);
      CHECK(drift.moment < round_off);
      CHECK(drift.second < round_off);
    }
  }
}

TEST_CASE("at a circle splitting conserves circulation and sum gamma X of the folded centroids") {
  const auto wall = body::circle({}, radius);
  const Blobs blobs = test::layer(1000, radius, 0.1, 0.01, 0.03);
  for (double alpha : {0.5, 0.7, 0.9}) {
    const Blobs split = halves(blobs, {0.015, alpha, 4}, wall.get());
    REQUIRE(split.size() > 2 * blobs.size());
    const test::Drift drift =
        test::drift(invariants(blobs, wall.get()), invariants(split, wall.get()));
    CHECK(drift.circulation < 1e-14 * test::strength(blobs));
    CHECK(drift.moment < 1e-15 * test::strength(blobs));
  }
}

TEST_CASE("no child lands inside the body, even of blobs that lie on the wall") {
  const auto wall = body::circle({}, radius);
  for (double deep : {0.0, 0.05}) {
    const Blobs split = halves(test::layer(500, radius, deep, 0.02, 0.1), {0.02}, wall.get());
    CHECK(depth(split, *wall) < 1e-15);
  }
}

TEST_CASE("only what is wider than sigma_max splits, into children of alpha times its width") {
  Blobs blobs;
  blobs.append({0.1, 0.2}, 1, 0.1);
  blobs.append({0.5, 0.2}, 2, 0.1001);
  const Blobs split = halves(blobs, {0.1, 0.7, 4}, nullptr);
  REQUIRE(split.size() == 5);
  CHECK(split.centre(0).x == 0.1);
  CHECK(split.gamma[0] == 1);
  for (std::size_t i = 1; i < 5; ++i) {
    CHECK(split.gamma[i] == 0.5);
    CHECK(split.sigma[i] == Approx(0.7 * 0.1001).epsilon(1e-15));
    CHECK(std::hypot(split.x[i] - 0.5, split.y[i] - 0.2) ==
          Approx(0.1001 * std::sqrt(1 - 0.49)).epsilon(1e-13));
  }
}

TEST_CASE("nothing wider than sigma_max remains when alpha brings the widest below it") {
  const auto wall = body::circle({}, radius);
  const Splitting splitting{0.1, 0.7, 4};
  CHECK(widest(halves(test::cloud(500, 0.05, 0.14), splitting, nullptr)) <= 0.1);
  // Beside the wall many Gaussians fold to all but the same; as they act none is wider.
  const Blobs layer = halves(test::layer(500, radius, 0.3, 0.05, 0.14), splitting, wall.get());
  CHECK(std::ranges::max(fold(layer, wall.get()).sigma) <= 0.1001);  // the wall is bent
}

TEST_CASE("the mirror image of a flow splits into its mirror image") {
  const auto wall = body::circle({}, radius);
  const Blobs blobs = test::layer(300, radius, 0.3, 0.01, 0.06);
  for (const body::Shape* shape : {wall.get(), static_cast<body::Shape*>(nullptr)}) {
    const Blobs there = test::mirrored(halves(blobs, {0.03}, shape));
    const Blobs here = halves(test::mirrored(blobs), {0.03}, shape);
    CHECK(test::apart(test::folded_there(here, shape), test::folded_there(there, shape)) < 1e-12);
  }
}

TEST_CASE("splitting gives the same bits again, and for any number of threads") {
  const auto wall = body::circle({}, radius);
  const Blobs blobs = test::layer(3000, radius, 0.3, 0.01, 0.06);
  const auto split = [&] { return halves(blobs, {0.03}, wall.get()); };
  const Blobs once = test::with_threads(1, split);
  CHECK(once == test::with_threads(1, split));
  CHECK(once == test::with_threads(2, split));
}

TEST_CASE("the ring turns from step to step and from seed to seed, and never with the order") {
  Blobs blobs;
  blobs.append({0, 0}, 1, 0.2);
  const Blobs one = halves(blobs, {0.1}, nullptr, 1);
  CHECK(test::apart(one, halves(blobs, {0.1}, nullptr, 2)) > 1e-3);
  CHECK(test::apart(one, halves(blobs, {.sigma_max = 0.1, .seed = 2}, nullptr, 1)) > 1e-3);
  Blobs many = test::cloud(200, 0.05, 0.2), reversed = many;
  for (auto* column : {&reversed.x, &reversed.y, &reversed.gamma, &reversed.sigma})
    std::ranges::reverse(*column);
  CHECK(test::apart(halves(many, {0.1}, nullptr), halves(reversed, {0.1}, nullptr)) == 0);
}

TEST_CASE("the field changes by the fourth moments: as (1 - alpha^2)^2 for alpha near 1") {
  // At the centre: children on a ring r show (1/alpha^2) exp(-r^2/(alpha sigma)^2) of the parent.
  const auto change = [](double alpha) {
    Blobs blobs;
    blobs.append({0, 0}, 1, 1);
    const Blobs split = halves(blobs, {0.9, alpha, 6}, nullptr);
    double centre = 0;
    for (std::size_t i = 0; i < split.size(); ++i) {
      const double s2 = split.sigma[i] * split.sigma[i], r2 = dot(split.centre(i), split.centre(i));
      centre += split.gamma[i] / s2 * std::exp(-r2 / s2);
    }
    return std::abs(centre - 1);
  };
  const double slope = std::log2(change(std::sqrt(0.98)) / change(std::sqrt(0.99)));
  CHECK(slope == Approx(2).margin(0.05));
}
