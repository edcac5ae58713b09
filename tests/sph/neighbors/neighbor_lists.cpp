#include "sph/neighbors/neighbor_lists.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "neighbors/methods.hpp"
#include "sph/operators/clouds.hpp"
#include "sph/operators/stencils.hpp"

using namespace vortree;
using namespace vortree::sph;
using namespace vortree::sph::test;

namespace {

/// Everything that stencils tell of neighbors.
std::vector<double> told(const Stencils& stencils) {
  std::vector<double> all;
  for (std::size_t i = 0; i < stencils.size(); ++i) {
    all.push_back(static_cast<double>(stencils.length(i)));
    stencils.for_each(i, [&](std::size_t j, std::size_t slot) {
      const Vec2 d = stencils.offset(slot);
      all.insert(all.end(), {static_cast<double>(j), d.x, d.y});
      for (int e = 0; e < 5; ++e) all.push_back(stencils.weight(e, slot));
    });
  }
  return all;
}

/// Moves, and leaves the square by one side to enter by the other.
void stir(Cloud& cloud, double by, double side, Chance& chance) {
  for (std::size_t i = 0; i < cloud.size(); ++i)
    for (auto* at : {&cloud.x, &cloud.y}) {
      double& place = (*at)[i];
      place += by * cloud.spacing[i] * (2 * chance.real() - 1);
      if (side > 0) place -= side * std::floor(place / side);
    }
}

}  // namespace

TEST_CASE("stencils have the same bits by every method and with any skin, if rows are sorted") {
  for (const double period : {0.0, 1.0}) {
    Chance chance(21);
    Cloud cloud = uneven_cloud(10, 5);
    std::vector<OperatorOptions> ways;
    for (const auto& maker : neighbors::makers())
      for (const double skin : {0.0, 0.3, 1.0})
        ways.push_back({.period = period, .neighbors = {maker.method, true, skin}});
    std::vector<Stencils> stencils(ways.size());
    for (int step = 0; step < 8; ++step) {
      std::vector<double> first;
      for (std::size_t k = 0; k < ways.size(); ++k) {
        stencils[k].renew(cloud, ways[k]);
        const std::vector<double> all = told(stencils[k]);
        if (k == 0) first = all;
        CAPTURE(period, step, word(ways[k].neighbors.method), ways[k].neighbors.skin);
        REQUIRE(all == first);
      }
      number(cloud);
      stir(cloud, 0.1, period, chance);
      if (step == 3) {
        std::vector<char> gone(cloud.size(), 0);
        gone[7] = gone[40] = 1;
        cloud.remove(gone);
      }
      if (step == 4) cloud.add({0.4, 0.6}, 0.05, ParticleKind::fluid);
      if (step == 5) sort(cloud);
    }
  }
}

TEST_CASE("unsorted rows hold the same neighbors") {
  const Cloud cloud = uneven_cloud(12, 6);
  Stencils sorted;
  sorted.renew(cloud, {});
  for (const auto& maker : neighbors::makers()) {
    Stencils any;
    any.renew(cloud, {.neighbors = {maker.method, false, 0}});
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      std::vector<std::size_t> found, expected;
      any.for_each(i, [&](std::size_t j, std::size_t) { found.push_back(j); });
      sorted.for_each(i, [&](std::size_t j, std::size_t) { expected.push_back(j); });
      CHECK(std::ranges::is_sorted(expected));
      std::ranges::sort(found);
      REQUIRE(found == expected);
    }
  }
}
