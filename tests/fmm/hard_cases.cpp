#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "fmm/direct.hpp"
#include "fmm/plan.hpp"
#include "fmm/reference.hpp"
#include "point_sets.hpp"

using namespace vortree;

namespace {

struct Cloud {
  std::vector<double> x, y, gamma, sigma;
  void add(double px, double py, double strength, double core = 0.0) {
    x.push_back(px), y.push_back(py), gamma.push_back(strength), sigma.push_back(core);
  }
  [[nodiscard]] fmm::Sources blobs() const { return {x, y, gamma, sigma}; }
  [[nodiscard]] fmm::Targets targets() const { return {x, y, sigma}; }
};

/// n blobs by a rule of position, gamma in [-1, 1].
template <class Place>
Cloud make_cloud(int n, double sigma, Place place) {
  Cloud cloud;
  test::Uniform uniform(static_cast<std::uint64_t>(n));
  for (int i = 0; i < n; ++i) {
    const double a = uniform(), b = uniform();
    const auto [x, y] = place(i, a, b);
    cloud.add(x, y, 2 * uniform() - 1, sigma);
  }
  return cloud;
}

void check(const char* shape, const Cloud& cloud, const fmm::Options& options, double bound) {
  CAPTURE(shape, options.tolerance, options.order);
  const std::size_t n = cloud.x.size();
  std::vector<double> u(n), v(n);
  fmm::Plan(cloud.blobs(), options).velocity(u, v);
  const test::Exact exact = test::exact_velocity(cloud.blobs(), cloud.targets(), options.cores);
  CHECK(test::error_of(u, v, exact).relative_l2 < bound);
}

using Place = std::pair<double, double>;
const auto square = [](int, double a, double b) { return Place{a, b}; };

}  // namespace

TEST_CASE("no blobs move nothing") {
  std::vector<double> none, u(2, 7.0), v(2, 7.0);
  const fmm::Plan plan({none, none, none, none}, {});
  plan.velocity(none, none);
  const std::vector<double> x{1, 2}, y{3, 4};
  plan.velocity({x, y, {}}, u, v);
  CHECK(u == std::vector<double>{0, 0});
  CHECK(v == std::vector<double>{0, 0});
  CHECK(plan.work().bare == 0);
  const fmm::Plan some({x, y, x, {}}, {});
  some.velocity({none, none, {}}, none, none);
}

TEST_CASE("one blob rests and turns what is around it anticlockwise") {
  const std::vector<double> x{3}, y{-2}, gamma{5}, sigma{0.5};
  const fmm::Plan plan({x, y, gamma, sigma}, {});
  std::vector<double> u{9}, v{9};
  plan.velocity(u, v);
  CHECK(u[0] == 0.0);
  CHECK(v[0] == 0.0);
  const std::vector<double> at_x{3.25}, at_y{-2};
  plan.velocity({at_x, at_y, {}}, u, v);
  CHECK(v[0] == Approx(5 / (2 * std::numbers::pi) * (1 - std::exp(-0.25)) / 0.25).epsilon(1e-7));
  CHECK(std::abs(u[0]) < 1e-15);
  plan.velocity_bare({at_x, at_y}, u, v);
  CHECK(v[0] == Approx(5 / (2 * std::numbers::pi) / 0.25).epsilon(1e-14));
}

TEST_CASE("two bare vortices circle each other") {
  const std::vector<double> x{0, 1}, y{0, 0}, gamma{1, 1};
  std::vector<double> u(2), v(2);
  fmm::Plan({x, y, gamma, {}}, {}).velocity(u, v);
  CHECK(v[0] == Approx(-1 / (2 * std::numbers::pi)).epsilon(1e-15));
  CHECK(v[1] == Approx(1 / (2 * std::numbers::pi)).epsilon(1e-15));
}

TEST_CASE("blobs all in one place rest") {
  const Cloud cloud = make_cloud(300, 0.0, [](int, double, double) { return Place{0.1, 0.7}; });
  std::vector<double> u(300, 1.0), v(300, 1.0);
  for (const int finest : {0, 5, 31}) {
    fmm::Plan(cloud.blobs(), {.capacity = 1, .finest_level = finest}).velocity(u, v);
    CHECK(u == std::vector<double>(300, 0.0));
    CHECK(v == std::vector<double>(300, 0.0));
  }
}

TEST_CASE("odd shapes keep the tolerance: lines, distant clusters, offsets, small trees") {
  const auto line = [](int, double a, double) { return Place{a, 0.25}; };
  const auto slant = [](int, double a, double) { return Place{a, 0.3 * a}; };
  const auto apart = [](int i, double a, double b) { return Place{a + (i % 2) * 1e8, b}; };
  const auto offset = [](int, double a, double b) { return Place{1e6 + a, -1e6 + b}; };
  const auto pairs = [](int i, double, double) {
    return Place{std::sin(i / 2) + (i % 2) * 1e-12, std::cos(i / 2)};
  };
  const auto stacks = [](int i, double, double) { return Place{i % 37 / 37.0, i % 11 / 11.0}; };
  const auto dust = [](int i, double, double) {  // every cell has its points in its corners
    Place at{0, 0};
    double side = 0.7;
    for (int k = 0; k < 5; ++k, i /= 4, side *= 0.3) {
      at.first += side * (i % 2), at.second += side * (i / 2 % 2);
    }
    return at;
  };
  const auto cluster = [](int i, double a, double b) {
    return i % 2 == 0 ? Place{a, b} : Place{1e-14 * a, 1e-14 * b};
  };
  for (const double sigma : {0.0, 0.02}) {
    CAPTURE(sigma);
    for (const double tolerance : {1e-4, 1e-6, 1e-10}) {
      const fmm::Options options{.tolerance = tolerance};
      const fmm::Options single{.tolerance = tolerance, .capacity = 1};
      const fmm::Options capped{.tolerance = tolerance, .capacity = 1, .finest_level = 3};
      check("line", make_cloud(800, sigma, line), options, tolerance);
      check("slant", make_cloud(800, sigma, slant), options, tolerance);
      check("apart", make_cloud(800, sigma, apart), options, tolerance);
      check("offset", make_cloud(800, sigma, offset), options, tolerance);
      check("pairs", make_cloud(800, sigma, pairs), options, tolerance);
      check("dust", make_cloud(1024, sigma, dust), options, tolerance);
      check("dust, single", make_cloud(1024, sigma, dust), single, tolerance);
      check("stacks", make_cloud(800, sigma, stacks), options, tolerance);
      check("cluster", make_cloud(800, sigma, cluster), options, tolerance);
      check("square, single", make_cloud(800, sigma, square), single, tolerance);
      check("square, capped", make_cloud(800, sigma, square), capped, tolerance);
      check("stacks, single", make_cloud(800, sigma, stacks), single, tolerance);
    }
  }
}

TEST_CASE("orders 1 and 100 are taken as they are asked") {
  const Cloud cloud = make_cloud(2000, 0.0, square);
  check("square", cloud, {.order = 1, .capacity = 10}, 1.0);
  check("square", cloud, {.order = 100, .capacity = 10}, 1e-14);
  CHECK(fmm::Plan(cloud.blobs(), {.order = 100}).order() == 100);
}

TEST_CASE("strengths of 1e-300 and 1e300 together, and all zero, end without NaN") {
  Cloud cloud = make_cloud(1000, 0.0, square);
  for (std::size_t i = 0; i < 1000; ++i) cloud.gamma[i] *= i % 2 == 0 ? 1e-300 : 1e300;
  for (std::size_t i = 0; i < 1000; i += 3) cloud.sigma[i] = 0.01;
  cloud.x[17] = cloud.x[18], cloud.y[17] = cloud.y[18];
  for (const double tolerance : {1e-4, 1e-10})
    check("square", cloud, {.tolerance = tolerance}, tolerance);
  std::ranges::fill(cloud.gamma, 0.0);
  std::vector<double> u(1000, 1.0), v(1000, 1.0);
  fmm::Plan(cloud.blobs(), {}).velocity(u, v);
  CHECK(u == std::vector<double>(1000, 0.0));
}

TEST_CASE("circulations that sum to zero, and one core over everything, keep the tolerance") {
  Cloud cloud = make_cloud(1000, 0.02, square);
  for (std::size_t i = 1; i < 1000; i += 2) cloud.gamma[i] = -cloud.gamma[i - 1];
  Cloud bare = cloud, covered = cloud;
  std::ranges::fill(bare.sigma, 0.0);
  covered.sigma[400] = 1e3;
  for (const double tolerance : {1e-4, 1e-6, 1e-10}) {
    for (const fmm::Cores cores : {fmm::Cores::source, fmm::Cores::mean}) {
      const fmm::Options options{.tolerance = tolerance, .cores = cores};
      check("sum zero", cloud, options, tolerance);
      check("sum zero, bare", bare, options, tolerance);
      check("covered", covered, options, tolerance);
    }
  }
}

TEST_CASE("targets far from all sources keep the tolerance") {
  for (const double away : {1.5, 10.0, 1e4}) {
    const Cloud cloud = make_cloud(1000, 0.02, square);
    const Cloud there = make_cloud(300, 0.0, [=](int, double a, double b) {
      return Place{away + a, -2 * away + b};
    });
    const fmm::Targets targets{there.x, there.y, {}};
    const test::Exact exact = test::exact_velocity(cloud.blobs(), targets, fmm::Cores::source);
    for (const double tolerance : {1e-4, 1e-6, 1e-10}) {
      CAPTURE(away, tolerance);
      std::vector<double> u(300), v(300);
      fmm::Plan(cloud.blobs(), {.tolerance = tolerance}).velocity(targets, u, v);
      CHECK(test::error_of(u, v, exact).relative_l2 < tolerance);
    }
  }
}

TEST_CASE("extreme lengths end without NaN, near and far") {
  const Cloud cloud = make_cloud(500, 1e-3, square);
  const std::vector<double> x{1e300, -1e154, 1e80, 0.5, cloud.x[7], cloud.x[8] + 1e-17};
  const std::vector<double> y{1e300, 1e154, 1e80, 1e-300, cloud.y[7], cloud.y[8]};
  const std::vector<double> sigma{0, 1e300, 1e-300, 1e200, 1e-160, 1e-3};
  std::vector<double> u(6), v(6);
  for (const fmm::Cores cores : {fmm::Cores::source, fmm::Cores::mean}) {
    const fmm::Plan plan(cloud.blobs(), {.cores = cores});
    plan.velocity({x, y, sigma}, u, v);
    for (int i = 0; i < 6; ++i) CHECK((std::isfinite(u[i]) && std::isfinite(v[i])));
    plan.velocity_bare({x, y}, u, v);
    for (int i = 0; i < 6; ++i) CHECK((std::isfinite(u[i]) && std::isfinite(v[i])));
    fmm::velocity_direct(cloud.blobs(), {x, y, sigma}, cores, u, v);
    for (int i = 0; i < 6; ++i) CHECK((std::isfinite(u[i]) && std::isfinite(v[i])));
  }
}

TEST_CASE("cores of every size sit side by side: bare, tiny, wide, wider than double can square") {
  Cloud cloud = make_cloud(600, 0.0, square);
  const double sizes[] = {0.0, 1e-200, 1e-80, 1e-9, 1e-3, 1.0, 1e90, 1e250};
  for (std::size_t i = 0; i < 600; ++i) cloud.sigma[i] = sizes[i % 8];
  for (const double tolerance : {1e-4, 1e-10}) {
    check("square", cloud, {.tolerance = tolerance, .cores = fmm::Cores::source}, tolerance);
  }
  std::vector<double> u(600), v(600);
  fmm::Plan(cloud.blobs(), {.cores = fmm::Cores::mean}).velocity(u, v);
  for (std::size_t i = 0; i < 600; ++i) CHECK((std::isfinite(u[i]) && std::isfinite(v[i])));
}
