#include "neighbors/methods.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "bench/sets/particle_sets.hpp"
#include "tree/pairs.hpp"
#include "tree/reaches.hpp"

using namespace vortree;
using tree::Listing;
using tree::PairRule;

namespace {

// As the rule says, at any scale (tests/tree/neighbors/exact_lists.cpp).
test::Pairs pairs_within(tree::Points p, std::span<const double> reach, PairRule rule) {
  test::Pairs pairs;
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < p.size(); ++j) {
      const double dx = p.x[j] - p.x[i], dy = p.y[j] - p.y[i], ri = reach[i], rj = reach[j];
      const bool near = rule == PairRule::max    ? tree::within<PairRule::max>(dx, dy, ri, rj)
                        : rule == PairRule::mean ? tree::within<PairRule::mean>(dx, dy, ri, rj)
                                                 : tree::within<PairRule::own>(dx, dy, ri, rj);
      if (j != i && near) pairs.emplace_back(i, j);
    }
  }
  return pairs;
}

// Every method finds the pairs of all pairs, listed as it should.
void check_methods(tree::Points points, std::span<const double> reach, PairRule rule) {
  const test::Pairs truth = pairs_within(points, reach, rule);
  for (const neighbors::NeighborMaker& maker : neighbors::makers()) {
    const auto method = maker.make();
    for (const Listing listing : {Listing::both_ways, Listing::once}) {
      if (rule == PairRule::own && listing == Listing::once) continue;
      CAPTURE(maker.name(), static_cast<int>(rule), static_cast<int>(listing), points.size());
      const neighbors::NeighborJob job{points, reach, rule, listing};
      tree::PairList rows;
      method->build(job);
      method->search(job, rows);
      REQUIRE(rows.size() == points.size());
      const bool equal = test::pairs_of(rows, listing) == truth;
      REQUIRE(equal);
    }
  }
}

}  // namespace

TEST_CASE("every method lists the pairs that a test of all pairs finds, on every set") {
  for (const char* name : {"uni:1", "uni:30", "cyl:1:20", "cyl:2:20", "cyl:3:20", "cyl:4:20",
                           "cyl:5:20", "foil:6:20", "foil:7:24"}) {
    const bench::ParticleSet set = bench::make_particles(name);
    for (const PairRule rule : {PairRule::max, PairRule::mean, PairRule::own}) {
      CAPTURE(name);
      check_methods(set.points(), set.reach, rule);
    }
  }
}

TEST_CASE("every method lists them for clusters and for any reach") {
  test::Chance chance(61);
  for (int round = 0; round < 100; ++round) {
    const test::Cloud cloud = test::any_cloud(200, chance);
    const int kind = chance.whole(0, test::reach_kinds - 1);
    const auto reach = test::make_reach(kind, cloud.x.size(), test::extent_of(cloud), chance);
    CAPTURE(round, cloud.name, kind);
    for (const PairRule rule : {PairRule::max, PairRule::mean, PairRule::own}) {
      check_methods(cloud.points(), reach, rule);
    }
  }
}

TEST_CASE("every method lists them at any scale, and down to the spacing of doubles far away") {
  test::Chance chance(62);
  for (int round = 0; round < 24; ++round) {
    test::Cloud cloud = test::make_cloud(chance.whole(0, test::cloud_kinds - 1), 80, chance);
    auto reach = test::make_reach(chance.whole(0, 5), cloud.x.size(), 1.0, chance);
    // The same cloud, by a power of two: its pairs are those of before, but for lost digits.
    const bool far = round % 2 == 0;
    const int scale = far ? -chance.whole(28, 53) : chance.whole(-1074, 1015);
    for (auto* values : {&cloud.x, &cloud.y, &reach}) {
      for (double& value : *values) value = std::ldexp(std::min(value, 16.0), scale);
    }
    if (far) {
      for (double& x : cloud.x) x += 1;
      for (double& y : cloud.y) y -= 7;
    }
    CAPTURE(round, cloud.name, scale);
    for (const PairRule rule : {PairRule::max, PairRule::mean, PairRule::own}) {
      check_methods(cloud.points(), reach, rule);
    }
  }
}

TEST_CASE("every method refuses more pairs than may be listed") {
  const bench::ParticleSet set = bench::make_particles("uni:30");
  for (const neighbors::NeighborMaker& maker : neighbors::makers()) {
    CAPTURE(maker.name());
    const neighbors::NeighborJob job{set.points(), set.reach};
    const auto method = maker.make();
    tree::PairList rows;
    rows.most = 100;
    method->build(job);
    CHECK_THROWS_AS(method->search(job, rows), std::length_error);
  }
}

TEST_CASE("at full size all fast methods list the same pairs") {
  const bench::ParticleSet set = bench::make_particles("cyl:5:100");
  std::vector<std::int64_t> truth;
  std::vector<std::uint64_t> sums;
  for (const neighbors::NeighborMaker& maker : neighbors::makers()) {
    if (maker.quadratic || maker.name() == "linked-list") continue;
    const neighbors::NeighborJob job{set.points(), set.reach};
    const auto method = maker.make();
    tree::PairList rows;
    method->build(job);
    method->search(job, rows);
    // Of rows as sets: their lengths, and a sum of hashes.
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (const std::int32_t j : rows.row(i)) {
        std::uint64_t h = i << 32 | static_cast<std::uint32_t>(j);
        h = (h ^ h >> 31) * 0x9e3779b97f4a7c15;
        sum += h ^ h >> 29;
      }
    }
    const auto start = rows.start.span();
    if (truth.empty()) truth.assign(start.begin(), start.end());
    CAPTURE(maker.name());
    CHECK(std::ranges::equal(truth, start));
    sums.push_back(sum);
  }
  CHECK(truth.back() > 1000000);
  CHECK(std::ranges::count(sums, sums[0]) == static_cast<std::ptrdiff_t>(sums.size()));
}
