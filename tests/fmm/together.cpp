#include <omp.h>

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "fmm/field/derivatives.hpp"
#include "fmm/plan.hpp"
#include "fmm/reference.hpp"
#include "point_sets.hpp"

using namespace vortree;

namespace {

enum class Widths { bare, even, mixed };

test::PointSet make_set(test::PointKind kind, std::size_t n, Widths width) {
  test::PointSet set = test::make_points(kind, n);
  test::Uniform uniform(99);
  for (std::size_t i = 0; i < n && width != Widths::bare; ++i) {
    set.sigma.push_back(width == Widths::even ? 2.0 / std::sqrt(static_cast<double>(n))
                                              : std::pow(10.0, -6.0 * uniform()));
  }
  return set;
}

/// u, v, du/dx, du/dy, dv/dx at the blobs.
std::array<std::vector<double>, 5> together(const fmm::Sources& blobs,
                                            const fmm::Options& options) {
  std::array<std::vector<double>, 5> found;
  for (auto& column : found) column.assign(blobs.size(), 7.0);
  auto& [u, v, ux, uy, vx] = found;
  fmm::Plan(blobs, options).velocity_and_gradient(u, v, ux, uy, vx);
  return found;
}

test::Fields slopes_of(const std::array<std::vector<double>, 5>& found, std::size_t stride) {
  test::Fields slopes(0);
  slopes.ux = test::every(stride, found[2]);
  slopes.uy = test::every(stride, found[3]);
  slopes.vx = test::every(stride, found[4]);
  slopes.psi.assign(slopes.ux.size(), 0.0);
  return slopes;
}

void check_sweep(const test::PointSet& set, fmm::Cores cores, fmm::SumMethod method,
                 std::initializer_list<double> tolerances) {
  const std::size_t stride = set.size() / 300;
  const std::vector<double> x = test::every(stride, set.x), y = test::every(stride, set.y),
                            sigma = test::every(stride, set.sigma);
  const fmm::Targets some{x, y, sigma};
  const test::Exact exact = test::exact_velocity(set.blobs(), some, cores);
  const auto exact_slopes = test::exact_fields(set.blobs(), some, cores);
  for (const double tolerance : tolerances) {
    CAPTURE(tolerance);
    const auto found =
        together(set.blobs(), {.tolerance = tolerance, .cores = cores, .method = method});
    CHECK(test::error_of(test::every(stride, found[0]), test::every(stride, found[1]), exact)
              .relative_l2 < tolerance);
    CHECK(test::errors_of(slopes_of(found, stride), exact_slopes).gradient < 10 * tolerance);
  }
}

}  // namespace

TEST_CASE("velocity and gradient together keep their tolerances, bare vortices") {
  for (const test::PointKind kind : test::every_kind) {
    CAPTURE(test::kind_names[static_cast<int>(kind)]);
    for (const fmm::SumMethod method : {fmm::SumMethod::fmm, fmm::SumMethod::boxes}) {
      check_sweep(make_set(kind, 6000, Widths::bare), fmm::Cores::source, method,
                  {1e-3, 1e-5, 1e-6, 1e-9, 1e-12});
    }
  }
}

TEST_CASE("velocity and gradient together keep their tolerances, cores of the spacing") {
  for (const test::PointKind kind : test::every_kind) {
    for (const fmm::Cores cores : {fmm::Cores::source, fmm::Cores::mean}) {
      CAPTURE(test::kind_names[static_cast<int>(kind)], static_cast<int>(cores));
      for (const fmm::SumMethod method : {fmm::SumMethod::fmm, fmm::SumMethod::boxes}) {
        check_sweep(make_set(kind, 6000, Widths::even), cores, method,
                    {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-9, 1e-12});
      }
    }
  }
}

TEST_CASE("velocity and gradient together keep their tolerances in a smooth flow") {
  for (const fmm::Cores cores : {fmm::Cores::source, fmm::Cores::mean}) {
    check_sweep(bench::make_blobs(8000), cores, fmm::SumMethod::fmm,
                {1e-3, 1e-5, 1e-6, 1e-9, 1e-12});
  }
}

TEST_CASE("velocity and gradient together keep their tolerances, cores from 1e-6 to 1") {
  for (const test::PointKind kind : test::every_kind) {
    for (const fmm::Cores cores : {fmm::Cores::source, fmm::Cores::mean}) {
      CAPTURE(test::kind_names[static_cast<int>(kind)], static_cast<int>(cores));
      check_sweep(make_set(kind, 3000, Widths::mixed), cores, fmm::SumMethod::fmm,
                  {1e-3, 1e-6, 1e-12});
    }
  }
}

TEST_CASE("velocity and gradient together are the same bits for any number of threads") {
  const int threads = omp_get_max_threads();
  for (const Widths width : {Widths::bare, Widths::even}) {
    const test::PointSet set = make_set(test::PointKind::ringwake, 20000, width);
    for (const double tolerance : {1e-5, 1e-9}) {
      omp_set_num_threads(1);
      const auto alone = together(set.blobs(), {.tolerance = tolerance, .cores = fmm::Cores::mean});
      for (const int count : {2, 3}) {
        omp_set_num_threads(count);
        CHECK(together(set.blobs(), {.tolerance = tolerance, .cores = fmm::Cores::mean}) == alone);
      }
      omp_set_num_threads(threads);
    }
  }
}

TEST_CASE("a crowd of blobs in one place does not move, but turns by its cores") {
  const std::size_t crowd = 700;
  test::PointSet set;
  for (std::size_t i = 0; i < crowd; ++i) {
    set.x.push_back(0.3), set.y.push_back(0.7);
    set.gamma.push_back(i % 2 == 0 ? 2.0 : 1.0), set.sigma.push_back(i % 7 == 0 ? 0.0 : 0.5);
  }
  set.x.push_back(5), set.y.push_back(0.7), set.gamma.push_back(0), set.sigma.push_back(0.5);
  for (const fmm::Cores cores : {fmm::Cores::source, fmm::Cores::mean}) {
    for (const fmm::SumMethod method : {fmm::SumMethod::fmm, fmm::SumMethod::boxes}) {
      for (const double tolerance : {1e-5, 1e-9}) {
        CAPTURE(static_cast<int>(cores), static_cast<int>(method), tolerance);
        const auto [u, v, ux, uy, vx] =
            together(set.blobs(), {.tolerance = tolerance, .cores = cores, .method = method});
        const auto exact = test::exact_fields(set.blobs(), {set.x, set.y, set.sigma}, cores);
        for (const std::size_t i : {std::size_t{0}, std::size_t{1}, crowd - 1, crowd}) {
          const double size = static_cast<double>(exact[0].vx);
          CHECK(std::abs(ux[i] - static_cast<double>(exact[i].ux)) < tolerance * size);
          CHECK(std::abs(uy[i] - static_cast<double>(exact[i].uy)) < tolerance * size);
          CHECK(std::abs(vx[i] - static_cast<double>(exact[i].vx)) < tolerance * size);
        }
        for (std::size_t i = 0; i < crowd; ++i) REQUIRE((u[i] == 0.0 && v[i] == 0.0));
      }
    }
  }
}

TEST_CASE("results together that do not fit are refused by name") {
  const std::vector<double> three{1, 2, 3};
  const fmm::Plan plan({three, three, three, {}}, {});
  std::vector<double> a(3), b(3), c(3), d(3), few(2);
  CHECK_THROWS_WITH(plan.velocity_and_gradient(a, b, c, few, d),
                    Catch::Matchers::Contains("uy has 2 values; it must have 3"));
}
