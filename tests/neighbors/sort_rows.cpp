#include "neighbors/sort_rows.hpp"

#include <catch2/catch.hpp>

#include "bench/sets/particle_sets.hpp"
#include "neighbors/methods.hpp"

using namespace vortree;

TEST_CASE("with sorted rows the lists of all methods are equal") {
  const bench::ParticleSet set = bench::make_particles("cyl:3:20");
  tree::PairList first;
  for (const neighbors::NeighborMaker& maker : neighbors::makers()) {
    const neighbors::NeighborJob job{set.points(), set.reach, tree::PairRule::mean};
    const auto method = maker.make();
    tree::PairList rows;
    method->build(job);
    method->search(job, rows);
    neighbors::sort_rows(rows);
    for (std::size_t i = 0; i < rows.size(); ++i) REQUIRE(std::ranges::is_sorted(rows.row(i)));
    if (first.size() == 0) first = rows;
    CAPTURE(maker.name());
    CHECK(std::ranges::equal(rows.start.span(), first.start.span()));
    CHECK(std::ranges::equal(rows.index.span(), first.index.span()));
  }
}

TEST_CASE("every method has the word of its place in the enumeration") {
  for (const neighbors::NeighborMaker& maker : neighbors::makers()) {
    CHECK(&neighbors::maker_of(maker.method) == &maker);
    CHECK(&neighbors::maker_of(maker.name()) == &maker);
  }
  CHECK(neighbors::makers().size() == words_of<neighbors::SearchMethod>.size());
  CHECK_THROWS_AS(neighbors::maker_of("octree"), std::invalid_argument);
}
