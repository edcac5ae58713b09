#include "bench/sets/particle_sets.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

using namespace vortree;
using bench::make_particles;
using bench::Order;
using bench::ParticleSet;

TEST_CASE("the sets have the paper's numbers of particles, to a thousandth") {
  // Khorasanizade & Sousa 2019, table 1: cases D to H, then B and C.
  const std::pair<const char*, double> counts[] = {
      {"cyl:1:100", 9976},  {"cyl:2:100", 10937}, {"cyl:3:100", 13916}, {"cyl:4:100", 18028},
      {"cyl:5:100", 33156}, {"cyl:1:200", 39920}, {"cyl:1:400", 159668}};
  for (const auto& [name, count] : counts) {
    CAPTURE(name);
    CHECK(static_cast<double>(make_particles(name).size()) == Approx(count).epsilon(1e-3));
  }
}

TEST_CASE("reach is halved from level to level, and no particle is in the body") {
  const ParticleSet set = make_particles("cyl:5:60");
  const double coarsest = 3.9 * 20 / 60;
  for (std::size_t i = 0; i < set.size(); ++i) {
    REQUIRE(set.reach[i] == static_cast<float>(std::ldexp(coarsest, -set.level[i])));
    REQUIRE(std::hypot(set.x[i], set.y[i]) > 0.5 - 0.15 * set.reach[i]);
    REQUIRE(std::max(std::abs(set.x[i]), std::abs(set.y[i])) < 10);
  }
  CHECK(*std::ranges::max_element(set.level) == 4);
}

TEST_CASE("the order changes nothing but the order") {
  const ParticleSet made = make_particles("foil:3:40", Order::made);
  for (const Order order : {Order::shuffled, Order::sorted}) {
    const ParticleSet set = make_particles("foil:3:40", order);
    const auto sorted = [](const ParticleSet& s) {
      std::vector<std::pair<double, double>> places;
      for (std::size_t i = 0; i < s.size(); ++i) places.emplace_back(s.x[i], s.y[i]);
      std::ranges::sort(places);
      return places;
    };
    CHECK(sorted(set) == sorted(made));
    CHECK(set.x != made.x);
    CHECK(std::accumulate(set.reach.begin(), set.reach.end(), 0.0) ==
          Approx(std::accumulate(made.reach.begin(), made.reach.end(), 0.0)));
  }
}

TEST_CASE("a set that does not exist is refused by name") {
  for (const char* name :
       {"", "uni", "uni:0", "uni:x", "cyl:5", "cyl:6:10", "foil:8:10", "box:3"}) {
    CHECK_THROWS_WITH(make_particles(name), Catch::Matchers::Contains("no particle set"));
  }
}
