#include "sph/neighbors/periodic_images.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <tuple>

#include "tree/clouds.hpp"

using namespace vortree::sph;

namespace {

PeriodicImages images(const std::vector<double>& x, const std::vector<double>& y,
                      const std::vector<double>& reach, double side) {
  PeriodicImages of;
  of.renew({x, y}, reach, std::vector<std::int32_t>(x.size(), -1), side);
  return of;
}

}  // namespace

TEST_CASE("images are all that are nearer to the square than the largest reach, each once") {
  vortree::test::Chance chance(91);
  std::vector<double> x, y, reach;
  for (int i = 0; i < 60; ++i) {
    x.push_back(3 * chance.real()), y.push_back(3 * chance.real());
    reach.push_back(0.1 + 0.5 * chance.real());
  }
  reach[7] = 0.7;
  const PeriodicImages all = images(x, y, reach, 3);
  std::set<std::tuple<int, long, long>> seen;
  for (std::size_t k = 0; k < all.of.size(); ++k) {
    const auto i = static_cast<std::size_t>(all.of[k]);
    if (k < x.size()) CHECK(i == k);
    const double across = (all.x[k] - x[i]) / 3, up = (all.y[k] - y[i]) / 3;
    CHECK(std::abs(across - std::round(across)) < 1e-14);
    CHECK(std::abs(up - std::round(up)) < 1e-14);
    CHECK(all.reach[k] == reach[i]);
    CHECK(seen.insert({all.of[k], std::lround(across), std::lround(up)}).second);
  }
  std::size_t near = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (const int a : {-1, 0, 1})
      for (const int b : {-1, 0, 1}) {
        const double there_x = x[i] + 3 * a, there_y = y[i] + 3 * b;
        near += there_x > -0.7 && there_x < 3.7 && there_y > -0.7 && there_y < 3.7;
      }
  CHECK(all.of.size() == near);
}

TEST_CASE("without a period particles have no images") {
  const std::vector<double> x{0.1, 5}, y{0, -3}, reach{1, 2};
  const PeriodicImages all = images(x, y, reach, 0);
  CHECK(all.x == x);
  CHECK(all.of == std::vector<std::int32_t>{0, 1});
  CHECK(images({}, {}, {}, 1).of.empty());
}
