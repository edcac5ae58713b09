#include "sph/sums.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "bench/sets/particle_sets.hpp"
#include "sph/kernels.hpp"

using namespace vortree;
using tree::Listing;
using tree::PairRule;

namespace {

struct Case {
  bench::ParticleSet set = bench::make_particles("cyl:5:40");
  std::vector<double> mass, f;
  sph::Sources sources() const { return {set.points(), mass, set.reach}; }
  Case() {
    for (std::size_t i = 0; i < set.size(); ++i) {
      const double dx = set.reach[i] / 3.9;
      mass.push_back(dx * dx);
      f.push_back(std::sin(0.3 * set.x[i]) + 0.2 * set.y[i]);
    }
  }
};

double worst(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

}  // namespace

TEST_CASE("density through full list, half list and visitor is the sum over all particles") {
  const Case c;
  const std::size_t n = c.set.size();
  std::vector<double> truth(n), full(n), half(n), shown(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const double r = std::hypot(c.set.x[i] - c.set.x[j], c.set.y[i] - c.set.y[j]);
      const double h = (c.set.reach[i] + c.set.reach[j]) / 4;
      truth[i] += c.mass[j] * sph::value(sph::Kernel::wendland_c6, 2, r, h);
    }
  }
  tree::Neighbors search;
  search.place(c.set.points(), c.set.reach);
  tree::PairList rows;
  search.list(PairRule::mean, Listing::both_ways, rows);
  sph::density(c.sources(), rows, Listing::both_ways, full);
  search.list(PairRule::mean, Listing::once, rows);
  sph::density(c.sources(), rows, Listing::once, half);
  sph::density(c.sources(), search, shown);
  CHECK(worst(full, truth) < 1e-12);
  CHECK(worst(half, truth) < 1e-12);
  CHECK(worst(shown, truth) < 1e-12);
  CHECK_THROWS_WITH(sph::density({c.set.points(), {}, c.set.reach}, rows, Listing::once, half),
                    Catch::Matchers::Contains("0 masses"));
}

TEST_CASE("the gradient is the same through all three, zero for constants, and roughly right") {
  const Case c;
  const std::size_t n = c.set.size();
  std::vector<double> gx(n), gy(n), hx(n), hy(n), vx(n), vy(n);
  tree::Neighbors search;
  search.place(c.set.points(), c.set.reach);
  tree::PairList rows;
  search.list(PairRule::mean, Listing::both_ways, rows);
  sph::gradient(c.sources(), c.mass, c.f, rows, Listing::both_ways, gx, gy);
  const std::vector<double> flat(n, 7.0);
  sph::gradient(c.sources(), c.mass, flat, rows, Listing::both_ways, vx, vy);
  CHECK(worst(vx, std::vector<double>(n, 0.0)) == 0);
  search.list(PairRule::mean, Listing::once, rows);
  sph::gradient(c.sources(), c.mass, c.f, rows, Listing::once, hx, hy);
  sph::gradient(c.sources(), c.mass, c.f, search, vx, vy);
  CHECK(worst(gx, hx) < 1e-11);
  CHECK(worst(gy, hy) < 1e-11);
  CHECK(worst(gx, vx) < 1e-11);
  CHECK(worst(gy, vy) < 1e-11);
  // Places are jittered by a tenth of the spacing, sizes jump by two: no better can be asked of it.
  double error = 0, whole = 0;
  for (std::size_t i = 0; i < n; ++i) {
    // Away from body and border, where the support is full.
    const double r = std::hypot(c.set.x[i], c.set.y[i]);
    if (r < 1 || std::max(std::abs(c.set.x[i]), std::abs(c.set.y[i])) > 7) continue;
    error += std::pow(gx[i] - 0.3 * std::cos(0.3 * c.set.x[i]), 2) + std::pow(gy[i] - 0.2, 2);
    whole += std::pow(0.3 * std::cos(0.3 * c.set.x[i]), 2) + 0.04;
  }
  CHECK(std::sqrt(error / whole) < 0.2);
}
