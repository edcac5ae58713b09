#include "vortex/adapt/lattice/laying.hpp"

#include <catch2/catch.hpp>

#include "body/shapes/circle.hpp"
#include "vortex/adapt/lattice/lay_onto_lattice.hpp"
#include "vortex/adapt/merge_close.hpp"
#include "vortex/strained_flows.hpp"

using namespace vortree;
using vortex::AdaptedBlob;
using vortex::Blobs;
using vortex::LatticeLevel;
using vortex::SplitScheme;
using vortex::Splitting;

namespace {

constexpr double radius = 0.5, sigma_max = 0.02;
const Splitting usual{.sigma_max = sigma_max, .scheme = SplitScheme::lattice};

Blobs laid(const Blobs& blobs, const Splitting& splitting, const body::Shape* wall,
           std::uint64_t step = 1) {
  return pack(split_apart(blobs, splitting, wall, step), wall);
}

/// Whether x is a whole number of steps.
bool on(double x, double step) {
  return std::abs(x / step - std::nearbyint(x / step)) < 1e-9;
}

Blobs one(Vec2 at, double sigma, double gamma = 1) {
  Blobs blobs;
  blobs.append(at, gamma, sigma);
  return blobs;
}

}  // namespace

TEST_CASE("beside a wall laying and splitting together keep circulation and the folded impulse") {
  const auto wall = body::circle({}, radius);
  const Blobs blobs = test::strained(test::layer(3000, radius, 0.3, 0.01, 0.03), 0.5);
  const Blobs after = laid(blobs, usual, wall.get());
  const test::Drift drift =
      test::drift(invariants(blobs, wall.get()), invariants(after, wall.get()));
  CHECK(drift.circulation < 1e-14 * test::strength(blobs));
  CHECK(drift.moment < 1e-14 * test::strength(blobs));
}

TEST_CASE(
    "free nodes are free of the wall's folding, as near as that lets them; nearer, along it") {
  const auto wall = body::circle({}, radius);
  const double s = 0.77 * sigma_max;
  double nearest = INFINITY;
  test::Uniform uniform(5);
  for (int k = 0; k < 20000; ++k) {
    const double phi = 2 * std::numbers::pi * uniform(), r = radius + sigma_max * 8 * uniform();
    const Blobs after = laid(one(r * vortree::Vec2{std::cos(phi), std::sin(phi)}, 1.05 * sigma_max),
                             usual, wall.get());
    REQUIRE(after.sigma[0] == Approx(s).epsilon(1e-12));
    const double h = LatticeLevel(sigma_max, 0).h;
    if (!on(after.x[0], h) || !on(after.y[0], h)) {  // along the wall
      CHECK(r - radius < 4.3 * s + 2 * h);
      continue;
    }
    for (std::size_t i = 0; i < after.size(); ++i)
      nearest = std::min(nearest, wall->distance(after.centre(i)));
  }
  CHECK(nearest > 4 * s);
  CHECK(nearest < 4.3 * s);
}

TEST_CASE("lattices coarsen with the cores: each level where they may be so wide") {
  const auto wall = body::circle({}, radius);
  Splitting splitting = usual;
  splitting.coarsening = {0.5};
  for (double distance : {0.3, 0.6, 0.9, 2.1, 10.0, 100.0}) {
    const float widening = splitting.coarsening.widening(distance);
    const int level = vortex::level_of(widening);
    CHECK(level == static_cast<int>(std::floor(2 * std::log2(widening))));
    const LatticeLevel lattice(sigma_max, level);
    const Blobs after = laid(one({radius + distance, 0.01}, std::sqrt(1.001 * lattice.least())),
                             splitting, wall.get());
    REQUIRE(after.size() == 9);
    for (std::size_t i = 0; i < 9; ++i) {
      CHECK(after.sigma[i] == Approx(std::sqrt(lattice.square)).epsilon(1e-14));
      CHECK((on(after.x[i], lattice.h) && on(after.y[i], lattice.h)));
    }
    CHECK(laid(one({radius + distance, 0.01}, std::sqrt(0.999 * lattice.least())), splitting,
               wall.get()) == one({radius + distance, 0.01}, std::sqrt(0.999 * lattice.least())));
  }
}

TEST_CASE("what is far too wide narrows level by level") {
  double sigma = 7 * sigma_max;
  int levels = 0;
  while (sigma > sigma_max) {
    const Blobs after = laid(one({0.3, 0.2}, sigma), usual, nullptr);
    REQUIRE(after.size() <= 9);
    CHECK(after.sigma[0] < 0.82 * sigma);
    CHECK(after.sigma[0] > 0.5 * sigma);
    sigma = after.sigma[0];
    ++levels;
  }
  CHECK(levels < 10);
}

TEST_CASE("all of a level are laid in the same step, those narrower than nodes wait") {
  const LatticeLevel lattice(sigma_max, 0);
  Splitting splitting = usual;
  splitting.spread =
      0.3 * (lattice.least() - lattice.square);  // four steps from lattice to lattice
  const auto pieces = [&](double square, std::uint64_t step) {
    return laid(one({0.1, 0.2}, std::sqrt(square)), splitting, nullptr, step).size();
  };
  for (const double square : {1.001 * lattice.square, lattice.least(), 1.5 * lattice.least()})
    for (const std::uint64_t step : {1, 2, 3, 4, 5, 6, 7, 8})
      CHECK(pieces(square, step) == (step % 4 == 0 ? 9 : 1));
  for (const std::uint64_t step : {1, 2, 3, 4}) {
    CHECK(pieces(0.999 * lattice.square, step) == 1);
    CHECK(pieces(2.01 * lattice.least(), step) == 9);  // too wide to wait
  }
}

TEST_CASE(
    "faint vorticity in free space has lattices up to twice as wide, beside a wall it has not") {
  const auto wall = body::circle({}, radius);
  Splitting splitting = usual;
  splitting.faint = 1;
  const double square = 1.05 * sigma_max * sigma_max;
  const auto pieces = [&](double vorticity, double wider, const body::Shape* shape) {
    const double wide = square * wider * wider;
    return laid(one({3, 0.2}, std::sqrt(wide), vorticity * wide), splitting, shape).size();
  };
  CHECK(pieces(1, 1, nullptr) == 9);
  CHECK(pieces(0.1, 1, nullptr) == 1);
  CHECK(pieces(0.1, std::sqrt(2), nullptr) == 9);
  CHECK(pieces(1e-3, 1.9, nullptr) == 1);
  CHECK(pieces(1e-3, 2, nullptr) == 9);
  CHECK(pieces(1e-3, 1, wall.get()) == 9);
}

TEST_CASE("strong nodes never merge, faint ones do, and what merges keeps its moments") {
  Blobs blobs;
  for (int i = -20; i <= 20; ++i)
    for (int j = -20; j <= 20; ++j) {
      const Vec2 at{0.018 * i, 0.018 * j};
      blobs.append(at, 1e-3 * std::exp(-dot(at, at) / 0.01), 0.0201);
    }
  vortex::AdaptedBlobs adapted = split_apart(blobs, usual, nullptr, 1);
  const std::size_t nodes = adapted.all.size();
  // gamma/2 > 0.1 tolerance s
  const auto strong = [](const AdaptedBlob& p) { return p.gamma > 2 * 0.1 * 0.02 * 0.77 * 0.0201; };
  std::vector<AdaptedBlob> kept;
  std::ranges::copy_if(adapted.all, std::back_inserter(kept), strong);
  REQUIRE(kept.size() > 200);
  merge_close(adapted, {.tolerance = 0.02, .reach = 3, .sigma_max = 0.022});
  CHECK(adapted.all.size() < 0.9 * nodes);
  for (const AdaptedBlob& a : kept)
    CHECK(std::ranges::count_if(adapted.all, [&](const AdaptedBlob& b) {
            return a.x == b.x && a.y == b.y && a.gamma == b.gamma && a.square == b.square;
          }) == 1);
  const Blobs after = pack(adapted, nullptr);
  const test::Drift drift = test::drift(invariants(blobs, nullptr), invariants(after, nullptr));
  CHECK(drift.circulation < 1e-14 * test::strength(blobs));
  CHECK(drift.moment < 1e-14 * test::strength(blobs));
  CHECK(drift.second < 1e-14 * test::strength(blobs));
}

TEST_CASE("a flow beside a wall and its mirror image are laid alike, for any number of threads") {
  const auto wall = body::circle({}, radius);
  const Blobs blobs = test::strained(test::layer(3000, radius, 0.3, 0.01, 0.03), 0.5);
  const auto lay = [&] { return laid(blobs, usual, wall.get()); };
  const Blobs once = test::with_threads(1, lay);
  CHECK(once == test::with_threads(2, lay));
  const Blobs there = test::mirrored(laid(test::mirrored(blobs), usual, wall.get()));
  CHECK(test::apart(test::folded_there(once, wall.get()), test::folded_there(there, wall.get())) <
        1e-8);  // on the wall, the root of round-off
}

TEST_CASE("a blob that is no number, or too far away for whole numbers, is not laid") {
  Blobs blobs = one({0.1, 0.2}, 0.03);
  blobs.append({1e12, 0.3}, 1, 0.03);
  blobs.append({0.1, 0.3}, NAN, 0.03);
  const Blobs after = laid(blobs, usual, nullptr);
  CHECK(after.size() == 9 + 4 + 4);  // the others split into rings
}
