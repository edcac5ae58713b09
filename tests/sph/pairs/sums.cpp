#include "sph/pairs/sums.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "bench/sets/particle_sets.hpp"
#include "papers.hpp"

using namespace vortree;
using tree::Listing;
using tree::PairRule;

namespace {

using Values = std::vector<double>;

// Places jittered by a tenth of the spacing, sizes from 16 to 1.
struct Case {
  bench::ParticleSet set = bench::make_particles("cyl:5:17");
  std::size_t n = set.size();
  Values mass, volume, f;

  Case() {
    for (std::size_t i = 0; i < n; ++i) {
      const double dx = set.reach[i] / 3.9;
      volume.push_back(dx * dx);
      mass.push_back(1.5 * dx * dx);
      f.push_back(std::sin(0.3 * set.x[i]) + 0.2 * set.y[i]);
    }
  }

  sph::SmoothedParticles sources(sph::Kernel kernel) const {
    return {set.points(), mass, set.reach, kernel};
  }
};

// Density, both parts of the gradient.
struct Sums {
  explicit Sums(std::size_t n) : rho(n), gx(n), gy(n) {}
  Values rho, gx, gy;
};

// A plain double loop, by the kernels as printed.
Sums all_pairs(const Case& c, sph::Kernel kernel) {
  Sums sums(c.n);
  for (std::size_t i = 0; i < c.n; ++i) {
    for (std::size_t j = 0; j < c.n; ++j) {
      const double dx = c.set.x[i] - c.set.x[j], dy = c.set.y[i] - c.set.y[j];
      const double r = std::hypot(dx, dy), reach = (c.set.reach[i] + c.set.reach[j]) / 2;
      const test::Printed w = test::printed(kernel, r, reach);
      sums.rho[i] += c.mass[j] * w.value(reach);
      if (i == j) continue;
      const double weight = c.volume[j] * (c.f[j] - c.f[i]) * w.derivative(reach) / r;
      sums.gx[i] += weight * dx, sums.gy[i] += weight * dy;
    }
  }
  return sums;
}

Sums by_list(const Case& c, sph::Kernel kernel, tree::Neighbors& search, Listing listing) {
  Sums sums(c.n);
  tree::PairList rows;
  search.list(PairRule::mean, listing, rows);
  sph::density(c.sources(kernel), rows, listing, sums.rho);
  sph::gradient(c.sources(kernel), c.volume, c.f, rows, listing, sums.gx, sums.gy);
  return sums;
}

Sums by_visitor(const Case& c, sph::Kernel kernel, tree::Neighbors& search) {
  Sums sums(c.n);
  sph::density(c.sources(kernel), search, sums.rho);
  sph::gradient(c.sources(kernel), c.volume, c.f, search, sums.gx, sums.gy);
  return sums;
}

double worst(const Values& a, const Values& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

double worst(const Sums& a, const Sums& b) {
  return std::max({worst(a.rho, b.rho), worst(a.gx, b.gx), worst(a.gy, b.gy)});
}

}  // namespace

TEST_CASE("with every kernel, sums by full list, half list and visitor are those over all pairs") {
  // A hundred terms at most, each known to some ten units of round-off of the largest.
  constexpr double rounding = 100 * 10 * 1e-16;
  const Case c;
  tree::Neighbors search;
  search.place(c.set.points(), c.set.reach);
  for (const sph::Kernel kernel : sph::every_kernel) {
    CAPTURE(sph::name_of(kernel));
    const Sums truth = all_pairs(c, kernel);
    CHECK(worst(by_list(c, kernel, search, Listing::both_ways), truth) < rounding);
    CHECK(worst(by_list(c, kernel, search, Listing::once), truth) < rounding);
    CHECK(worst(by_visitor(c, kernel, search), truth) < rounding);
  }
}

TEST_CASE("with every kernel, the gradient of a constant is zero, to the last bit") {
  Case c;
  c.f.assign(c.n, 7);
  tree::Neighbors search;
  search.place(c.set.points(), c.set.reach);
  const Values zero(c.n);
  for (const sph::Kernel kernel : sph::every_kernel) {
    CAPTURE(sph::name_of(kernel));
    for (const Listing listing : {Listing::both_ways, Listing::once}) {
      const Sums sums = by_list(c, kernel, search, listing);
      CHECK(worst(sums.gx, zero) == 0);
      CHECK(worst(sums.gy, zero) == 0);
    }
  }
}

TEST_CASE("with every kernel, particles at one place add up in density and not in the gradient") {
  const Values x{0, 0}, y{0, 0}, mass{1, 2}, reach{2, 2}, f{1, 5};
  tree::Neighbors search;
  search.place({x, y}, reach);
  for (const sph::Kernel kernel : sph::every_kernel) {
    CAPTURE(sph::name_of(kernel));
    Values rho(2), gx(2), gy(2);
    sph::density({{x, y}, mass, reach, kernel}, search, rho);
    sph::gradient({{x, y}, mass, reach, kernel}, mass, f, search, gx, gy);
    const double middle = test::printed(kernel, 0, 2).value(2);
    CHECK(rho[0] == Approx(3 * middle).epsilon(1e-14));
    CHECK(rho[1] == Approx(3 * middle).epsilon(1e-14));
    CHECK(worst(gx, {0, 0}) == 0);
    CHECK(worst(gy, {0, 0}) == 0);
  }
}

TEST_CASE("sums refuse sizes that differ") {
  const Case c;
  tree::Neighbors search;
  search.place(c.set.points(), c.set.reach);
  Values rho(c.n);
  CHECK_THROWS_WITH(sph::density({c.set.points(), {}, c.set.reach}, search, rho),
                    Catch::Matchers::Contains("0 masses"));
}
