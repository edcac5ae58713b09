#include "vortex/adapt/bins.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>

#include "point_sets.hpp"

using namespace vortree;
using vortex::Bins;

namespace {

/// How many points within the distance are missing from the runs, or there more than once.
int missed(const Bins& bins, const std::vector<double>& x, const std::vector<double>& y, Vec2 at,
           double distance) {
  std::vector<int> found(x.size());
  bins.runs_near(at, distance, [&](std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t k = first; k < last; ++k) ++found[bins.order()[k]];
  });
  int missing = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const bool near = std::hypot(x[i] - at.x, y[i] - at.y) <= distance;
    missing += near ? found[i] != 1 : found[i] > 1;
  }
  return missing;
}

std::size_t looked_at(const Bins& bins, Vec2 at, double distance) {
  std::size_t count = 0;
  bins.runs_near(at, distance,
                 [&](std::uint32_t first, std::uint32_t last) { count += last - first; });
  return count;
}

}  // namespace

TEST_CASE("runs near a place hold every point within the distance, once") {
  for (test::PointKind kind : test::every_kind) {
    const test::PointSet set = test::make_points(kind, 2000);
    for (double side : {0.005, 0.1, 3.0}) {
      const Bins bins(set.x, set.y, side);
      int missing = 0;
      for (std::size_t i = 0; i < set.size(); i += 20)
        for (double distance : {0.0, 0.02, 0.3})
          missing += missed(bins, set.x, set.y, {set.x[i], set.y[i]}, distance);
      CHECK(missing == 0);
    }
  }
}

TEST_CASE("places outside the cloud find what is near them, and else look at little") {
  const test::PointSet set = test::make_points(test::PointKind::uniform, 2000);
  const Bins bins(set.x, set.y, 0.05);
  for (Vec2 at : {Vec2{-0.1, 0.5}, Vec2{1.1, 1.1}, Vec2{0.5, 1e9}, Vec2{-1e30, 0.5}})
    CHECK(missed(bins, set.x, set.y, at, 0.2) == 0);
  CHECK(looked_at(bins, {0.5, 0.5}, 0.05) < 100);
}

TEST_CASE("the order of bins names every point once") {
  const test::PointSet set = test::make_points(test::PointKind::hard, 1000);
  const Bins bins(set.x, set.y, 0.01);
  std::vector<std::uint32_t> order(bins.order().begin(), bins.order().end());
  std::ranges::sort(order);
  std::vector<std::uint32_t> every(1000);
  std::iota(every.begin(), every.end(), 0u);
  CHECK(order == every);
}

TEST_CASE("stragglers far away cost no memory: there are no more cells than some sixteen a point") {
  test::PointSet set = test::make_points(test::PointKind::uniform, 500);
  for (Vec2 straggler : {Vec2{1e12, 0}, Vec2{0, -1e12}, Vec2{-1e12, 1e12}}) {
    auto x = set.x, y = set.y;
    x.push_back(straggler.x);
    y.push_back(straggler.y);
    const Bins bins(x, y, 1e-6);  // 1e36 cells, were they all kept
    CHECK(missed(bins, x, y, {0.5, 0.5}, 0.1) == 0);
    CHECK(missed(bins, x, y, straggler, 0.1) == 0);
  }
}

TEST_CASE("one point, points all in one place and none at all are binned too") {
  CHECK(looked_at(Bins({}, {}, 1), {0, 0}, 5) == 0);
  const std::vector<double> one{0.3}, same(50, 0.3);
  CHECK(looked_at(Bins(one, one, 0.1), {0.3, 0.3}, 0.1) == 1);
  CHECK(looked_at(Bins(same, same, 0.1), {0.31, 0.3}, 0.1) == 50);
}
