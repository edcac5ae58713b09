#include "vortex/adapt/merge_windows.hpp"

#include <catch2/catch.hpp>

#include "vortex/flows.hpp"

using namespace vortree;
using vortex::Blobs;
using vortex::Merging;

namespace {

const Merging usual{.tolerance = 20, .sigma_max = 0.05};

Blobs in_windows(const Blobs& blobs, double shift = 0, const Merging& merging = usual) {
  vortex::AdaptedBlobs adapted = unpack(blobs, nullptr);
  merge_in_windows(adapted, merging, shift);
  return pack(adapted, nullptr);
}

}  // namespace

TEST_CASE("merging in windows conserves circulation, impulse and second moment to round-off") {
  const Blobs blobs = test::cloud(5000, 0.02, 0.04);
  for (double shift : {0.0, 0.37}) {
    const Blobs fewer = in_windows(blobs, shift);
    REQUIRE(fewer.size() < 0.8 * blobs.size());
    const test::Drift drift = test::drift(invariants(blobs, nullptr), invariants(fewer, nullptr));
    CHECK(drift.circulation < 1e-14 * test::strength(blobs));
    CHECK(drift.moment < 1e-14 * test::strength(blobs));
    CHECK(drift.second < 1e-14 * test::strength(blobs));
  }
}

TEST_CASE("windows leave at most a fifth more than merging all with all within reach does") {
  const Blobs blobs = test::cloud(20000, 0.02, 0.04);
  Blobs all = blobs;
  merge_close(all, usual, nullptr);
  CHECK(in_windows(in_windows(blobs), 0.37).size() < 1.2 * all.size());
}

TEST_CASE("windows are the same whatever the order of the blobs, and for any number of threads") {
  const Blobs blobs = test::cloud(20000, 0.02, 0.04);
  Blobs reversed = blobs;
  for (auto* column : {&reversed.x, &reversed.y, &reversed.gamma, &reversed.sigma})
    std::ranges::reverse(*column);
  const auto merged = [&] { return in_windows(blobs); };
  const Blobs once = test::with_threads(1, merged);
  CHECK(once == test::with_threads(2, merged));
  CHECK(once == test::with_threads(3, merged));
  const Blobs there = in_windows(reversed);
  CHECK(once.x.size() == there.x.size());
  CHECK(test::apart(once, there) < 1e-12);
}

TEST_CASE("windows of a mirror image are mirrored") {
  const Blobs blobs = test::cloud(20000, 0.02, 0.04);
  CHECK(test::mirrored(in_windows(test::mirrored(blobs))).size() == in_windows(blobs).size());
  CHECK(test::apart(test::mirrored(in_windows(test::mirrored(blobs))), in_windows(blobs)) < 1e-15);
}

TEST_CASE("far stragglers cost no memory, and blobs of one place merge") {
  Blobs blobs = test::cloud(1000, 0.02, 0.04);
  blobs.append({1e12, -1e9}, 1, 0.03);
  blobs.append({-1e15, 1e15}, -1, 0.03);
  for (int i = 0; i < 100; ++i) blobs.append({3, 3}, 0.01, 0.03);
  const Blobs fewer = in_windows(in_windows(blobs));
  CHECK(std::ranges::count(fewer.x, 3.0) == 1);
  CHECK(std::ranges::count(fewer.x, 1e12) == 1);
  CHECK(std::ranges::count(fewer.x, -1e15) == 1);
}
