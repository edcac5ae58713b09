#include "bench/rivals/velocity/grid.hpp"

#include <omp.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>
#include <string>

#include "bench/measures/accuracy.hpp"
#include "bench/sets/point_sets.hpp"
#include "fmm/direct.hpp"

using namespace vortree;
using bench::PointSet;

namespace {

struct Velocity {
  std::vector<double> u, v;
  explicit Velocity(std::size_t n) : u(n), v(n) {}
  bool operator==(const Velocity&) const = default;
};

fmm::Targets own(const PointSet& set) {
  return {set.x, set.y, {}};
}

Velocity on_grid(const PointSet& set, const fmm::Targets& targets, double tolerance) {
  Velocity found(targets.size());
  bench::velocity_grid(set.blobs(), targets, {.tolerance = tolerance}, found.u, found.v);
  return found;
}

Velocity directly(const PointSet& set, const fmm::Targets& targets) {
  Velocity found(targets.size());
  fmm::velocity_direct(set.blobs(), targets, fmm::Cores::source, found.u, found.v);
  return found;
}

double relative_l2(const Velocity& found, const Velocity& expected) {
  double missed = 0.0, whole = 0.0;
  for (std::size_t i = 0; i < found.u.size(); ++i) {
    missed += std::pow(found.u[i] - expected.u[i], 2) + std::pow(found.v[i] - expected.v[i], 2);
    whole += std::pow(expected.u[i], 2) + std::pow(expected.v[i], 2);
  }
  return std::sqrt(missed / whole);
}

PointSet random_blobs(std::size_t n, double sigma) {
  PointSet set = bench::make_points(bench::PointKind::uniform, n);
  set.sigma.assign(n, sigma);
  return set;
}

std::string refusal(const PointSet& set) {
  try {
    on_grid(set, own(set), 1e-6);
  } catch (const std::invalid_argument& refused) {
    return refused.what();
  }
  return "none";
}

}  // namespace

TEST_CASE("the grid keeps to the tolerance, from 1e-2 to 1e-13") {
  const PointSet set =
      GENERATE(bench::make_blobs(2000), random_blobs(2000, 0.02), random_blobs(2000, 0.15));
  const bench::Exact exact = bench::exact_velocity(set.blobs(), own(set), 300);
  for (double tolerance = 1e-2; tolerance > 0.5e-13; tolerance *= 0.1) {
    const Velocity found = on_grid(set, own(set), tolerance);
    CAPTURE(tolerance);
    CHECK(bench::velocity_error(exact, found.u, found.v).relative_l2 <= tolerance);
  }
}

TEST_CASE("the grid is free space: a flat, a distant and a lonely flow are as exact") {
  PointSet flat = random_blobs(500, 0.05), distant = random_blobs(500, 0.05);
  for (double& y : flat.y) y *= 1e-3;
  for (double& x : distant.x) x += 1000.0;
  CHECK(relative_l2(on_grid(flat, own(flat), 1e-10), directly(flat, own(flat))) <= 1e-10);
  CHECK(relative_l2(on_grid(distant, own(distant), 1e-10), directly(distant, own(distant))) <=
        1e-10);

  const PointSet lonely{{0.3}, {0.7}, {2.0}, {0.1}};
  const std::vector<double> x{0.35, 2.0}, y{0.7, -1.0};
  const fmm::Targets elsewhere{x, y, {}};
  CHECK(relative_l2(on_grid(lonely, elsewhere, 1e-10), directly(lonely, elsewhere)) <= 1e-10);
  CHECK(std::abs(on_grid(lonely, own(lonely), 1e-10).u[0]) <= 1e-10);
}

TEST_CASE("targets may lie outside the vorticity") {
  const PointSet set = random_blobs(300, 0.1);
  PointSet at = bench::make_points(bench::PointKind::ringwake, 200);
  const fmm::Targets targets{at.x, at.y, {}};
  CHECK(relative_l2(on_grid(set, targets, 1e-9), directly(set, targets)) <= 1e-9);
}

TEST_CASE("the grid gives the same bits for any number of threads") {
  const PointSet set = bench::make_blobs(5000);
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const Velocity one = on_grid(set, own(set), 1e-6);
  omp_set_num_threads(3);
  const Velocity three = on_grid(set, own(set), 1e-6);
  omp_set_num_threads(threads);
  CHECK(one == three);
}

TEST_CASE("the grid refuses what it is not good for, with numbers") {
  PointSet bare = bench::make_points(bench::PointKind::uniform, 100), mixed = bare, tiny = bare;
  CHECK(refusal(bare).find("bare") != std::string::npos);
  mixed.sigma.assign(100, 0.1);
  mixed.sigma[7] = 0.2;
  CHECK(refusal(mixed).find("from 0.1 to 0.2") != std::string::npos);
  mixed.sigma[7] = 0.0;
  CHECK(refusal(mixed).find("bare") != std::string::npos);
  tiny.sigma.assign(100, 1e-7);
  CHECK(refusal(tiny).find("1e-07") != std::string::npos);
  CHECK_THROWS_AS(on_grid(bare, own(bare), 0.0), std::invalid_argument);
}

TEST_CASE("no blobs make no velocity, no targets ask for none") {
  const PointSet none, some = random_blobs(3, 0.1);
  const Velocity found = on_grid(none, own(some), 1e-6);
  CHECK(found.u == std::vector<double>(3, 0.0));
  CHECK(on_grid(some, own(none), 1e-6).u.empty());
}
