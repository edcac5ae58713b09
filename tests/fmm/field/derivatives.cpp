#include "fmm/field/derivatives.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "fmm/direct.hpp"
#include "fmm/field/field.hpp"
#include "fmm/plan.hpp"
#include "fmm/vorticity.hpp"
#include "point_sets.hpp"

using namespace vortree;

namespace {

constexpr double pi = std::numbers::pi;

enum class Widths { bare, even, mixed };

struct Cloud {
  test::PointSet set;
  std::vector<double> x, y, sigma;  // targets: some of the blobs, then other places

  Cloud(test::PointSet some, Widths width, std::size_t probes) : set(std::move(some)) {
    test::Uniform uniform(99);
    const std::size_t n = set.size();
    for (std::size_t j = 0; j < n && width != Widths::bare; ++j) {
      set.sigma.push_back(width == Widths::even ? 2.0 / std::sqrt(static_cast<double>(n))
                                                : std::pow(10.0, -6.0 * uniform()));
    }
    for (std::size_t i = 0; i < probes; ++i) {
      const std::size_t j = i * (n / probes);
      x.push_back(i % 2 == 0 ? set.x[j] : 1.4 * uniform() - 0.2);
      y.push_back(i % 2 == 0 ? set.y[j] : 1.4 * uniform() - 0.2);
      if (width != Widths::bare) sigma.push_back(i % 3 == 0 ? 0.0 : set.sigma[j]);
    }
  }
  [[nodiscard]] fmm::Targets targets() const { return {x, y, sigma}; }
};

void check_sweep(const Cloud& cloud, fmm::Cores cores, std::initializer_list<double> tolerances) {
  const auto exact = test::exact_fields(cloud.set.blobs(), cloud.targets(), cores);
  for (const fmm::SumMethod method : {fmm::SumMethod::fmm, fmm::SumMethod::boxes}) {
    for (const double tolerance : tolerances) {
      CAPTURE(static_cast<int>(method), tolerance);
      const fmm::Plan plan(cloud.set.blobs(),
                           {.tolerance = tolerance, .cores = cores, .method = method});
      const test::FieldErrors errors = test::errors_of(test::Fields(plan, cloud.targets()), exact);
      CHECK(errors.gradient < tolerance);
      CHECK(errors.stream_function < tolerance);
    }
  }
}

}  // namespace

TEST_CASE("what a core makes of the logarithm agrees with its plain twin and with tables") {
  // E1(1), E1(5) of Abramowitz & Stegun, table 5.1
  CHECK(static_cast<double>(fmm::core_log_plain(1)) == Approx(0.219383934395520).epsilon(1e-14));
  CHECK(static_cast<double>(fmm::core_log_plain(5)) ==
        Approx(std::log(5.0) + 1.148295591275e-3).epsilon(1e-14));
  CHECK(static_cast<double>(fmm::core_log_plain(0)) == Approx(-std::numbers::egamma));
  const fmm::CoreLog& table = fmm::CoreLog::table();
  test::Uniform uniform(5);
  for (int k = 0; k < 5000; ++k) {
    const double q = k % 2 == 0 ? fmm::bare_log * uniform() : std::exp(-40 * uniform());
    const double found = table(fill(q))[0];
    REQUIRE(std::abs(found - static_cast<double>(fmm::core_log_plain(q))) <=
            6e-16 * std::max(1.0, std::abs(found)));
  }
}

TEST_CASE("logarithms keep the last bits, near one and at the ends of the range") {
  test::Uniform uniform(6);
  for (int k = 0; k < 5000; ++k) {
    const double x = k % 2 == 0 ? std::exp(1400 * (uniform() - 0.5)) : 1 + 0.8 * (uniform() - 0.5);
    REQUIRE(std::abs(fmm::logarithm(fill(x))[0] - std::log(x)) <= 5e-16 * std::abs(std::log(x)));
  }
  CHECK(fmm::logarithm(fill(1.0))[0] == 0.0);
}

TEST_CASE("near pairs agree with their plain twin to round-off, from r = 1e-7 cores to 30") {
  test::Uniform uniform(7);
  const fmm::CoreShares shares(fmm::Cores::source);
  for (int k = 0; k < 3000; ++k) {
    const double angle = 2 * pi * uniform(), sigma = std::exp(-8 * uniform());
    const double r = k % 100 == 0 ? 0.0 : sigma * std::exp(std::log(1e-7) + 19.5 * uniform());
    const double gamma = 2 * uniform() - 1, core = sigma * sigma;
    fmm::PackedSources source;
    source.restart(1);
    source.add(0.0, 0.0, gamma, core);
    source.close();
    std::vector<double> x(8, r * std::cos(angle)), y(8, r * std::sin(angle)), cores(8), sum[4];
    for (auto& values : sum) values.assign(8, 0.0);
    fmm::FieldGradient{}.add_cored(
        source, shares,
        {x.data(), y.data(), cores.data(), {&sum[0][0], &sum[1][0], &sum[2][0]}, 1});
    fmm::StreamFunction{0.0, {}}.add_cored(source, shares,
                                           {x.data(), y.data(), cores.data(), {&sum[3][0]}, 1});
    test::ExactFields exact;
    exact.add_cored(gamma, x[0], y[0], core);
    const auto agree = [&](double found, long double expected, long double size) {
      REQUIRE(std::abs(found - static_cast<double>(expected)) <= 1e-14 * static_cast<double>(size));
    };
    const long double size =
        std::hypot(std::hypot(exact.ux, exact.ux), std::hypot(exact.uy, exact.vx));
    agree(sum[1][0], exact.ux, size);
    agree(sum[0][0] - sum[2][0], exact.uy, size);
    agree(sum[0][0] + sum[2][0], exact.vx, size);
    agree(sum[3][0] / -2, exact.psi, std::abs(gamma) * (1 + std::abs(std::log(core))));
  }
}

TEST_CASE("the direct sum of the gradient is right to round-off") {
  for (const Widths width : {Widths::bare, Widths::even, Widths::mixed}) {
    for (const fmm::Cores cores : {fmm::Cores::source, fmm::Cores::mean}) {
      CAPTURE(static_cast<int>(width), static_cast<int>(cores));
      const Cloud cloud(test::make_points(test::PointKind::uniform, 1500), width, 150);
      const auto exact = test::exact_fields(cloud.set.blobs(), cloud.targets(), cores);
      test::Fields found(cloud.x.size());
      fmm::gradient_direct(cloud.set.blobs(), cloud.targets(), cores, found.ux, found.uy, found.vx);
      CHECK(test::errors_of(found, exact).gradient < 1e-14);
    }
  }
}

TEST_CASE("gradient and stream function keep the tolerance, bare vortices") {
  for (const test::PointKind kind : test::every_kind) {
    CAPTURE(test::kind_names[static_cast<int>(kind)]);
    check_sweep({test::make_points(kind, 8000), Widths::bare, 300}, fmm::Cores::source,
                {1e-3, 1e-5, 1e-6, 1e-9, 1e-12});
  }
}

TEST_CASE("gradient and stream function keep the tolerance, cores of the spacing") {
  for (const test::PointKind kind : test::every_kind) {
    for (const fmm::Cores cores : {fmm::Cores::source, fmm::Cores::mean}) {
      CAPTURE(test::kind_names[static_cast<int>(kind)], static_cast<int>(cores));
      check_sweep({test::make_points(kind, 8000), Widths::even, 300}, cores,
                  {1e-3, 1e-6, 1e-9, 1e-12});
    }
  }
}

TEST_CASE("gradient and stream function keep the tolerance, cores from 1e-6 to 1") {
  for (const test::PointKind kind : test::every_kind) {
    for (const fmm::Cores cores : {fmm::Cores::source, fmm::Cores::mean}) {
      CAPTURE(test::kind_names[static_cast<int>(kind)], static_cast<int>(cores));
      check_sweep({test::make_points(kind, 3000), Widths::mixed, 200}, cores, {1e-3, 1e-6, 1e-12});
    }
  }
}

TEST_CASE("gradient and stream function keep the tolerance in a smooth flow") {
  test::PointSet set = bench::make_blobs(8000);
  const auto sigma = std::move(set.sigma);
  set.sigma.clear();
  check_sweep({set, Widths::bare, 300}, fmm::Cores::source, {1e-3, 1e-6, 1e-9, 1e-12});
  check_sweep({set, Widths::even, 300}, fmm::Cores::source, {1e-3, 1e-6, 1e-9, 1e-12});
}

TEST_CASE("differences of the velocity are the gradient, of the stream function the velocity") {
  for (const Widths width : {Widths::bare, Widths::even}) {
    const Cloud cloud(test::make_points(test::PointKind::ringwake, 2000), width, 100);
    const fmm::Plan plan(cloud.set.blobs(), {.tolerance = 1e-13});
    const double step = width == Widths::bare ? 1e-6 : 1e-5;
    std::vector<double> x, y;
    for (std::size_t i = 1; i < cloud.x.size(); i += 2) {  // not at the blobs
      for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        x.push_back(cloud.x[i] + dx * step), y.push_back(cloud.y[i] + dy * step);
      }
    }
    const fmm::Targets targets{x, y, {}};
    const test::Fields fields(plan, targets);
    std::vector<double> u(x.size()), v(x.size());
    plan.velocity(targets, u, v);
    for (std::size_t k = 0; k < x.size(); k += 5) {
      const auto slope_x = [&](const std::vector<double>& f) {
        return (f[k + 1] - f[k + 2]) / (x[k + 1] - x[k + 2]);
      };
      const auto slope_y = [&](const std::vector<double>& f) {
        return (f[k + 3] - f[k + 4]) / (y[k + 3] - y[k + 4]);
      };
      const double gradient = std::abs(fields.ux[k]) + std::abs(fields.uy[k]) + 1;
      CHECK(std::abs(slope_x(u) - fields.ux[k]) < 1e-5 * gradient);
      CHECK(std::abs(slope_y(v) + fields.ux[k]) < 1e-5 * gradient);
      CHECK(std::abs(slope_y(u) - fields.uy[k]) < 1e-5 * gradient);
      CHECK(std::abs(slope_x(v) - fields.vx[k]) < 1e-5 * gradient);
      const double speed = std::hypot(u[k], v[k]) + 1;
      CHECK(std::abs(slope_y(fields.psi) - u[k]) < 1e-6 * speed);
      CHECK(std::abs(slope_x(fields.psi) + v[k]) < 1e-6 * speed);
    }
  }
}

TEST_CASE("the rotation is the vorticity") {
  const Cloud cloud(test::make_points(test::PointKind::uniform, 3000), Widths::even, 300);
  const test::Fields fields(fmm::Plan(cloud.set.blobs(), {.tolerance = 1e-12}), cloud.targets());
  std::vector<double> omega(cloud.x.size());
  fmm::vorticity(cloud.set.blobs(), {cloud.x, cloud.y}, omega, 1e-13);
  double most = 0.0;
  for (const double value : omega) most = std::max(most, std::abs(value));
  for (std::size_t i = 0; i < omega.size(); ++i) {
    CHECK(std::abs(fields.vx[i] - fields.uy[i] - omega[i]) < 1e-9 * most);
  }
}

TEST_CASE("no blobs have no gradient and no stream function, no targets ask for nothing") {
  const std::vector<double> none, x{1, 2}, y{3, 4};
  for (const fmm::SumMethod method : {fmm::SumMethod::fmm, fmm::SumMethod::boxes}) {
    const test::Fields fields(fmm::Plan({none, none, none, none}, {.method = method}),
                              fmm::Targets{x, y, {}});
    for (const auto* values : {&fields.ux, &fields.uy, &fields.vx, &fields.psi}) {
      CHECK(*values == std::vector<double>{0, 0});
    }
    const test::Fields nothing(fmm::Plan({x, y, x, {}}, {.method = method}),
                               fmm::Targets{none, none, {}});
    CHECK(nothing.psi.empty());
  }
}

TEST_CASE("one blob turns its middle as a solid, and its stream function ends there") {
  const std::vector<double> x{3}, y{-2}, gamma{5}, sigma{0.5};
  for (const fmm::SumMethod method : {fmm::SumMethod::fmm, fmm::SumMethod::boxes}) {
    const fmm::Plan plan({x, y, gamma, sigma}, {.method = method});
    const test::Fields middle(plan, fmm::Targets{x, y, {}});
    CHECK(middle.ux[0] == 0.0);
    CHECK(middle.vx[0] == Approx(5 / (2 * pi) / 0.25).epsilon(1e-14));
    CHECK(middle.uy[0] == -middle.vx[0]);
    CHECK(middle.psi[0] ==
          Approx(-5 / (4 * pi) * (std::log(0.25) - std::numbers::egamma)).epsilon(1e-14));
    const fmm::Plan bare({x, y, gamma, {}}, {.method = method});
    const test::Fields nothing(bare, fmm::Targets{x, y, {}});
    for (const auto* values : {&nothing.ux, &nothing.uy, &nothing.vx, &nothing.psi}) {
      CHECK((*values)[0] == 0.0);
    }
    const std::vector<double> right{3.25}, far{1e100};
    const test::Fields beside(bare, fmm::Targets{right, y, {}});
    CHECK(beside.ux[0] == 0.0);
    CHECK(beside.uy[0] == Approx(-5 / (2 * pi) / 0.0625).epsilon(1e-14));
    CHECK(beside.vx[0] == beside.uy[0]);
    CHECK(beside.psi[0] == Approx(-5 / (2 * pi) * std::log(0.25)).epsilon(1e-14));
    const test::Fields away(bare, fmm::Targets{far, far, {}});
    CHECK(away.psi[0] == Approx(-5 / (2 * pi) * std::log(std::sqrt(2) * 1e100)).epsilon(1e-14));
  }
}

namespace {

/// 0: all in one place. 1: a line. 2: far from the origin. 3: two clusters 1e8 apart. 4: a cluster
/// of 1e-13. 5: stacks of coincident blobs.
test::PointSet make_hard(int shape, bool cored) {
  test::PointSet set;
  test::Uniform uniform(17);
  for (int i = 0; i < 600; ++i) {
    double x = uniform(), y = uniform();
    if (shape == 0) x = 0.3, y = 0.7;
    if (shape == 1) y = 0.25;
    if (shape == 2) x += 1e6, y -= 1e6;
    if (shape == 3 && i % 2 == 0) x += 1e8;
    if (shape == 4 && i % 2 == 0) x = 0.7 + 1e-13 * x, y = -0.3 + 1e-13 * y;
    if (shape == 5) x = i % 7, y = i % 3;
    set.x.push_back(x), set.y.push_back(y), set.gamma.push_back(2 * uniform() - 1);
    if (cored) set.sigma.push_back(i % 5 == 0 ? 0.0 : 0.02);
  }
  return set;
}

}  // namespace

TEST_CASE("hard sets keep the tolerance: coincident, in line, far off, apart, dense") {
  for (int shape = 0; shape < 6; ++shape) {
    for (const bool cored : {false, true}) {
      CAPTURE(shape, cored);
      const test::PointSet set = make_hard(shape, cored);
      if (shape == 0 && !cored) continue;  // nothing, see below
      const fmm::Targets targets{set.x, set.y, {}};
      const auto exact = test::exact_fields(set.blobs(), targets, fmm::Cores::source);
      for (const fmm::SumMethod method : {fmm::SumMethod::fmm, fmm::SumMethod::boxes}) {
        for (const double tolerance : {1e-4, 1e-10}) {
          for (const std::uint32_t capacity : {0u, 1u}) {
            CAPTURE(static_cast<int>(method), tolerance, capacity);
            const fmm::Plan plan(set.blobs(),
                                 {.tolerance = tolerance, .capacity = capacity, .method = method});
            const test::FieldErrors errors = test::errors_of(test::Fields(plan, targets), exact);
            CHECK(errors.gradient < tolerance);
            CHECK(errors.stream_function < tolerance);
          }
        }
      }
    }
  }
}

TEST_CASE("other units of length add a constant to the stream function, and nothing else") {
  test::PointSet set = make_hard(5, true);
  const fmm::Targets targets{set.x, set.y, {}};
  const test::Fields here(fmm::Plan(set.blobs(), {}), targets);
  test::PointSet scaled = set;
  for (auto* values : {&scaled.x, &scaled.y, &scaled.sigma}) {
    for (double& value : *values) value *= 0x1p40;
  }
  for (double& gamma : scaled.gamma) gamma *= 0x1p60;
  const test::Fields there(fmm::Plan(scaled.blobs(), {}), {scaled.x, scaled.y, {}});
  const auto exact =
      test::exact_fields(scaled.blobs(), {scaled.x, scaled.y, {}}, fmm::Cores::source);
  CHECK(test::errors_of(there, exact).stream_function < 1e-7);
  for (std::size_t i = 0; i < set.size(); ++i) CHECK(there.ux[i] == here.ux[i] * 0x1p-20);
}

TEST_CASE("strengths of 1e-300 and 1e250 and extreme places end without NaN") {
  test::PointSet set = make_hard(5, true);
  for (std::size_t i = 0; i < set.size(); ++i) set.gamma[i] *= i % 2 == 0 ? 1e-300 : 1e250;
  set.sigma[3] = 1e59, set.sigma[4] = 1e-65;
  std::vector<double> x = set.x, y = set.y;
  for (const double at : {1e300, -1e154, 1e80, 1e-300, 1e-17}) x.push_back(at), y.push_back(at);
  const std::vector<double> wide(x.size(), 1e59);
  for (const fmm::Cores cores : {fmm::Cores::source, fmm::Cores::mean}) {
    for (const fmm::SumMethod method : {fmm::SumMethod::fmm, fmm::SumMethod::boxes}) {
      const fmm::Plan plan(set.blobs(), {.cores = cores, .method = method});
      const test::Fields fields(plan, fmm::Targets{x, y, wide});
      for (const auto* values : {&fields.ux, &fields.uy, &fields.vx, &fields.psi}) {
        for (const double value : *values) REQUIRE(std::isfinite(value));
      }
    }
  }
}

TEST_CASE("results that do not fit are refused by name") {
  using Catch::Matchers::Contains;
  const std::vector<double> three{1, 2, 3};
  const fmm::Plan plan({three, three, three, {}}, {});
  std::vector<double> a(3), b(3), few(2);
  CHECK_THROWS_WITH(plan.gradient({three, three, {}}, a, few, b),
                    Contains("uy has 2 values; it must have 3"));
  CHECK_THROWS_WITH(plan.stream_function({three, three, {}}, few), Contains("psi has 2 values"));
  const std::vector<double> broken{1, std::numeric_limits<double>::quiet_NaN(), 3};
  CHECK_THROWS_WITH(plan.stream_function({three, broken, {}}, a), Contains("y[1] is nan"));
}
