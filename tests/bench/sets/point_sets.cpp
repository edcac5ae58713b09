#include "bench/sets/point_sets.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <numbers>

using namespace vortree::bench;

namespace {

// Of the bits of the values, in order (FNV-1a).
std::uint64_t fingerprint(const std::vector<double>& values) {
  std::uint64_t hash = 14695981039346656037u;
  for (const double value : values) {
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    hash = (hash ^ bits) * 1099511628211u;
  }
  return hash;
}

}  // namespace

TEST_CASE("the uniform set is the same bit for bit on every machine") {
  const PointSet set = make_points(PointKind::uniform, 1000);
  CHECK(fingerprint(set.x) == 0xe64d352e2860c598u);
  CHECK(fingerprint(set.y) == 0xd5ff86fb94e105b5u);
  CHECK(fingerprint(set.gamma) == 0xb8a177a944377ebdu);
}

TEST_CASE("every set has as many points as asked for, all of them finite and apart") {
  for (const std::size_t n : {0, 1, 7, 1000}) {
    for (const PointKind kind : every_kind) {
      const PointSet set = make_points(kind, n);
      REQUIRE(set.size() == n);
      CHECK(set.gamma.size() == n);
      CHECK(set.sigma.empty());
      for (std::size_t i = 0; i < n; ++i) {
        REQUIRE((std::isfinite(set.x[i]) && std::isfinite(set.y[i])));
        REQUIRE(std::abs(set.gamma[i]) <= 1.0);
        if (i > 0) REQUIRE((set.x[i] != set.x[i - 1] || set.y[i] != set.y[i - 1]));
      }
    }
    CHECK(make_blobs(n).size() == n);
  }
}

TEST_CASE("blobs overlap, fill the unit square and turn as much one way as the other") {
  const PointSet set = make_blobs(10000);
  CHECK(set.sigma == std::vector<double>(10000, 0.02));
  double total = 0.0, left = 0.0, magnitude = 0.0;
  for (std::size_t i = 0; i < set.size(); ++i) {
    REQUIRE((set.x[i] >= 0.0 && set.x[i] <= 1.0 && set.y[i] >= 0.0 && set.y[i] <= 1.0));
    total += set.gamma[i];
    magnitude += std::abs(set.gamma[i]);
    if (set.x[i] < 0.5) left += 1.0;
  }
  CHECK(left == 5000.0);
  CHECK(std::abs(total) < 1e-3 * magnitude);
  CHECK(magnitude == Approx(4.0 / (std::numbers::pi * std::numbers::pi)).epsilon(1e-2));
}
