#include "vortex/cores/halves.hpp"

#include <catch2/catch.hpp>

#include "vortex/strained_flows.hpp"

using namespace vortree;
using vortex::Blobs;
using vortex::Halves;

TEST_CASE("two halves have circulation, impulse and all second moments of the blob") {
  for (const double most : {0.01, 0.5, 0.99}) {
    const Blobs blobs = test::strained(test::cloud(500, 0.01, 0.1), most);
    for (std::size_t i = 0; i < blobs.size(); ++i) {
      Blobs one;
      one.append({0.1, -0.2}, blobs.gamma[i], blobs.core(i));
      const Halves halves(one);
      if (!halves.halved(0)) continue;
      const double round_off = 1e-15 * std::abs(one.gamma[0]);
      CHECK(test::difference(test::second_moments(one), test::second_moments(halves.parts)) <
            round_off);
      const test::Drift drift =
          test::drift(invariants(one, nullptr), invariants(halves.parts, nullptr));
      CHECK(drift.circulation < round_off);
      CHECK(drift.moment < round_off);
    }
  }
}

TEST_CASE("halves are round, and lie along the major axis") {
  for (const double phi : {0.0, 0.4, 1.6, 3.0, -0.7}) {
    const vortex::Deviator d{0.1 * std::cos(2 * phi), 0.1 * std::sin(2 * phi)};
    const Vec2 way = vortex::to_half(d);
    CHECK(dot(way, way) == Approx(0.2).epsilon(1e-14));
    CHECK(std::abs(way.x * std::sin(phi) - way.y * std::cos(phi)) < 1e-8);
  }
  const Blobs parts = Halves(test::strained(test::cloud(100, 0.01, 0.1), 0.9)).parts;
  CHECK(parts.size() > 190);
  CHECK(std::ranges::count(parts.xx, 0.0) == std::ssize(parts.xx));
}

TEST_CASE("round blobs are themselves, to the bit") {
  const Blobs blobs = test::cloud(100, 0.01, 0.1);
  CHECK(Halves(blobs).parts == blobs);
}
