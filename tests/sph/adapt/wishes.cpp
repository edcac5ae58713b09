#include "sph/adapt/wishes.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "sph/operators/clouds.hpp"

using namespace vortree;
using namespace vortree::sph;
using namespace vortree::sph::test;

namespace {

constexpr double far = std::numeric_limits<double>::infinity();
constexpr OuterBox anywhere{{-far, -far}, {far, far}};

/// A periodic square of lattice spacing 1/40 that turns like a solid of radius 0.1 in its middle,
/// with vorticity 10, and is at rest elsewhere.
struct Eddy {
  Cloud cloud = lattice({0, 0}, {1, 1}, 0.025);
  Stencils stencils;
  std::vector<Slopes> slopes;

  Eddy() {
    stencils.renew(cloud, {2, 2.8, 1});
    slopes.resize(cloud.size());
    for (std::size_t i = 0; i < cloud.size(); ++i)
      if (from_middle(i) < 0.1) slopes[i][1].x = 5, slopes[i][0].y = -5;
  }
  double from_middle(std::size_t i) const {
    const Vec2 d = cloud.at(i) - Vec2{0.5, 0.5};
    return std::sqrt(dot(d, d));
  }
  std::vector<double> wish(const VorticityWish& by, const WantedSpacing& wanted) {
    return wishes({cloud, stencils, slopes, 1}, wanted, by);
  }
};

WantedSpacing levels(int count) {
  return {nullptr, 0.01, count, 0, 2};
}

}  // namespace

TEST_CASE("particles are as fine as vorticity asks for, and as coarse as can be far from it") {
  Eddy eddy;
  const std::vector<double> wish = eddy.wish({0.2, 0.01, anywhere}, levels(4));
  for (std::size_t i = 0; i < wish.size(); ++i) {
    CHECK(wish[i] >= 0.01);
    CHECK(wish[i] <= 0.08);
    if (eddy.from_middle(i) < 0.03) CHECK(wish[i] == Approx(0.2 / 10).epsilon(1e-12));
    // It is 0.02 within 0.1 + 0.07, the reach, at most, and widens by a quarter from there.
    if (eddy.from_middle(i) > 0.17 + 4 * 0.06) CHECK(wish[i] == 0.08);
  }
}

TEST_CASE("they are never finer than the finest, however strong vorticity is") {
  Eddy eddy;
  for (const double w : eddy.wish({1e-9, 0.01, anywhere}, levels(3))) CHECK(w >= 0.01);
  for (const double w : eddy.wish({1e9, 0.01, anywhere}, levels(3))) CHECK(w == 0.04);
}

TEST_CASE("from neighbor to neighbor the wish widens by no more than a quarter of the distance") {
  Eddy eddy;
  const std::vector<double> wish = eddy.wish({0.1, 0.01, anywhere}, levels(4));
  for (std::size_t i = 0; i < wish.size(); ++i)
    eddy.stencils.for_each(i, [&](std::size_t j, std::size_t slot) {
      const Vec2 d = eddy.stencils.offset(slot);
      REQUIRE(wish[i] <= wish[j] + 0.25 * std::sqrt(dot(d, d)) + 1e-15);
    });
}

TEST_CASE("beside the box the wish is as coarse as its nodes, and finer inwards as it may") {
  Eddy eddy;
  const OuterBox near{{0.45, -9}, {9, 9}};  // its left side passes the eddy
  const std::vector<double> wish = eddy.wish({0.1, 0.01, near}, levels(4));
  bool finer = false;
  for (std::size_t i = 0; i < wish.size(); ++i) {
    const double least = std::max(0.01, 0.08 - 0.25 * near.depth(eddy.cloud.at(i)));
    CHECK(wish[i] >= std::min(least, 0.08) - 1e-15);
    finer = finer || wish[i] < 0.07;
  }
  CHECK(finer);
}

TEST_CASE("what a place asks for counts where it is finer") {
  Eddy eddy;
  WantedSpacing wanted = levels(4);
  wanted.add_ellipse({0, 0}, {0.1, 0.1}, 0, 0.015);
  const std::vector<double> wish = eddy.wish({0.2, 0.01, anywhere}, wanted);
  for (std::size_t i = 0; i < wish.size(); ++i) CHECK(wish[i] <= wanted.at(eddy.cloud.at(i)));
  CHECK(wish.front() == 0.015);
  const std::vector<double> plain = wishes({eddy.cloud, eddy.stencils, eddy.slopes, 1}, wanted);
  for (std::size_t i = 0; i < plain.size(); ++i) CHECK(plain[i] == wanted.at(eddy.cloud.at(i)));
}
