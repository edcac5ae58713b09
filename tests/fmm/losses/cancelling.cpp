#include "fmm/losses/cancelling.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string_view>
#include <vector>

#include "fmm/plan.hpp"
#include "fmm/reference.hpp"
#include "fmm/whole_reference.hpp"

using namespace vortree;

namespace {

struct Places {
  std::vector<double> x, y, sigma;
  [[nodiscard]] fmm::Targets targets() const { return {x, y, sigma}; }
};

/// Every few blobs; all gradients and stream functions are asked for there.
constexpr std::size_t stride = 13;

Places some_blobs(const test::Cancelling& set) {
  return {test::every(stride, set.x), test::every(stride, set.y), test::every(stride, set.sigma)};
}

/// Over the extent of the blobs and a little beyond.
Places elsewhere(const test::Cancelling& set) {
  const auto [left, right] = std::ranges::minmax(set.x);
  const auto [bottom, top] = std::ranges::minmax(set.y);
  test::Uniform uniform(3);
  Places places;
  for (int k = 0; k < 60; ++k) {
    places.x.push_back(left + (1.4 * uniform() - 0.2) * (right - left));
    places.y.push_back(bottom + (1.4 * uniform() - 0.2) * (top - bottom));
  }
  return places;
}

void check_velocity(const std::vector<double>& u, const std::vector<double>& v,
                    const std::vector<test::Whole>& exact, double tolerance) {
  test::Kept kept(tolerance);
  for (std::size_t i = 0; i < exact.size(); ++i) {
    kept.add(u[i] - exact[i].u, exact[i].u);
    kept.add(v[i] - exact[i].v, exact[i].v);
    kept.add_contributions(exact[i].all_u);
  }
  CHECK(kept.ratio() <= 1);
}

void check_gradient(const std::vector<double>& ux, const std::vector<double>& uy,
                    const std::vector<double>& vx, const std::vector<test::Whole>& exact,
                    double tolerance) {
  test::Kept kept(tolerance);
  for (std::size_t i = 0; i < exact.size(); ++i) {
    kept.add(ux[i] - exact[i].ux, exact[i].ux, 2);  // dv/dy is -du/dx
    kept.add(uy[i] - exact[i].uy, exact[i].uy);
    kept.add(vx[i] - exact[i].vx, exact[i].vx);
    kept.add_contributions(2 * exact[i].all_slopes);
  }
  CHECK(kept.ratio() <= 1);
}

void check_at(const fmm::Plan& plan, const Places& places, const std::vector<test::Whole>& exact,
              double tolerance) {
  const std::size_t n = places.x.size();
  std::vector<double> u(n), v(n), ux(n), uy(n), vx(n), psi(n);
  plan.velocity(places.targets(), u, v);
  check_velocity(u, v, exact, tolerance);
  plan.gradient(places.targets(), ux, uy, vx);
  check_gradient(ux, uy, vx, exact, tolerance);
  plan.stream_function(places.targets(), psi);
  test::Kept kept(tolerance);
  for (std::size_t i = 0; i < n; ++i) {
    kept.add(psi[i] - exact[i].psi, exact[i].psi);
    kept.add_contributions(exact[i].all_psi);
  }
  CHECK(kept.ratio() <= 1);
}

void check_together(const fmm::Plan& plan, const std::vector<test::Whole>& exact,
                    double tolerance) {
  const std::size_t n = plan.size();
  std::vector<double> u(n), v(n), ux(n), uy(n), vx(n);
  plan.velocity(u, v);
  check_velocity(test::every(stride, u), test::every(stride, v), exact, tolerance);
  plan.velocity_and_gradient(u, v, ux, uy, vx);
  check_velocity(test::every(stride, u), test::every(stride, v), exact, tolerance);
  check_gradient(test::every(stride, ux), test::every(stride, uy), test::every(stride, vx), exact,
                 10 * tolerance);
}

}  // namespace

TEST_CASE("the tolerance is kept where sums cancel, down to what doubles can hold") {
  for (const test::Cancelling& set : test::cancelling_sets()) {
    const Places at = some_blobs(set), away = elsewhere(set);
    for (const fmm::Cores cores : {fmm::Cores::source, fmm::Cores::mean}) {
      if (cores == fmm::Cores::mean && set.sigma[0] == 0.0) continue;
      const auto exact = test::whole_reference(set.blobs(), at.targets(), cores);
      const auto exact_away = test::whole_reference(set.blobs(), away.targets(), cores);
      for (const fmm::SumMethod method : {fmm::SumMethod::fmm, fmm::SumMethod::boxes}) {
        for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-9, 1e-13}) {
          CAPTURE(set.name, set.sigma[0], static_cast<int>(cores), static_cast<int>(method),
                  tolerance);
          const fmm::Plan plan(set.blobs(),
                               {.tolerance = tolerance, .cores = cores, .method = method});
          check_together(plan, exact, tolerance);
          check_at(plan, at, exact, tolerance);
          check_at(plan, away, exact_away, tolerance);
        }
      }
    }
  }
}

TEST_CASE("where sums cancel, threads, builders and the order of blobs leave the same bits") {
  test::Cancelling set{"cored dipoles", {}, {}, {}, {}},
      turned{"the other way round", {}, {}, {}, {}};
  test::add_groups(set, 500, 2, 1e-7, 0.01);
  const std::size_t n = set.x.size();
  for (std::size_t i = n; i-- > 0;) {
    turned.add(set.x[i], set.y[i], set.gamma[i], set.sigma[i]);
  }
  std::vector<double> u(n), v(n), other_u(n), other_v(n);
  for (const fmm::SumMethod method : {fmm::SumMethod::fmm, fmm::SumMethod::boxes}) {
    fmm::Options options{.tolerance = 1e-4, .method = method};
    fmm::Plan(set.blobs(), options).velocity(u, v);
    fmm::Plan(turned.blobs(), options).velocity(other_u, other_v);
    std::ranges::reverse(other_u);
    CHECK(u == other_u);
    options.builder = fmm::Builder::forward;
    fmm::Plan(set.blobs(), options).velocity(other_u, other_v);
    CHECK(u == other_u);
    CHECK(v == other_v);
  }
}

TEST_CASE("ordinary clouds are summed once") {
  for (const test::PointKind kind : test::every_kind) {
    CAPTURE(test::kind_names[static_cast<int>(kind)]);
    const test::PointSet set = test::make_points(kind, 4000);
    std::vector<double> u(set.size()), v(u), ux(u), uy(u), vx(u);
    for (const double core : {0.0, 2.0 / std::sqrt(4000.0)}) {
      const std::vector<double> sigma(core > 0 ? set.size() : 0, core);
      const fmm::Sources blobs{set.x, set.y, set.gamma, sigma};
      for (const double tolerance : {1e-2, 1e-3, 1e-6, 1e-9, 1e-12}) {
        for (const fmm::SumMethod method : {fmm::SumMethod::fmm, fmm::SumMethod::boxes}) {
          CAPTURE(core, tolerance, static_cast<int>(method));
          int trees = 0;
          const fmm::Plan plan(blobs, {.tolerance = tolerance, .method = method},
                               [&](std::string_view part) { trees += part == "tree" ? 1 : 0; });
          plan.velocity(u, v);
          plan.velocity_and_gradient(u, v, ux, uy, vx);
          CHECK(trees == 1);
        }
      }
    }
  }
}
