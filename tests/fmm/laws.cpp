#include <omp.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "fmm/direct.hpp"
#include "fmm/plan.hpp"
#include "point_sets.hpp"

using namespace vortree;

namespace {

struct Field {
  std::vector<double> u, v;
  explicit Field(std::size_t n) : u(n), v(n) {}
  bool operator==(const Field&) const = default;
};

std::vector<double> varied_cores(std::size_t n) {
  test::Uniform uniform(5);
  std::vector<double> sigma(n);
  for (double& value : sigma) value = 0.01 + 0.03 * uniform();
  return sigma;
}

/// |sum gamma (u, v)| over sum |gamma| |(u, v)|: the drift of the impulse.
double drift(const std::vector<double>& gamma, const Field& field) {
  double x = 0, y = 0, whole = 0;
  for (std::size_t i = 0; i < gamma.size(); ++i) {
    x += gamma[i] * field.u[i];
    y += gamma[i] * field.v[i];
    whole += std::abs(gamma[i]) * std::hypot(field.u[i], field.v[i]);
  }
  return std::hypot(x, y) / whole;
}

}  // namespace

TEST_CASE("mean cores conserve sum gamma x: exactly in the direct sum, to tolerance in a plan") {
  const test::PointSet set = test::make_points(test::PointKind::ringwake, 5000);
  const std::vector<double> sigma = varied_cores(set.size());
  const fmm::Sources blobs{set.x, set.y, set.gamma, sigma};
  Field direct(set.size()), planned(set.size());
  fmm::velocity_direct(blobs, {set.x, set.y, sigma}, fmm::Cores::mean, direct.u, direct.v);
  CHECK(drift(set.gamma, direct) < 1e-15);
  fmm::Plan(blobs, {.tolerance = 1e-9, .cores = fmm::Cores::mean}).velocity(planned.u, planned.v);
  CHECK(drift(set.gamma, planned) < 1e-9);
  fmm::velocity_direct(blobs, {set.x, set.y, {}}, fmm::Cores::source, direct.u, direct.v);
  CHECK(drift(set.gamma, direct) > 1e-6);  // the cores differ, so this law is no triviality
}

TEST_CASE("any number of threads gives the same bits") {
  const int threads = omp_get_max_threads();
  for (const double tolerance : {1e-4, 1e-10}) {
    const test::PointSet set = test::make_points(test::PointKind::hard, 6000);
    const std::vector<double> sigma = varied_cores(set.size());
    std::vector<Field> fields;
    for (const int count : {1, 2, 5}) {
      omp_set_num_threads(count);
      const fmm::Plan plan({set.x, set.y, set.gamma, sigma}, {.tolerance = tolerance});
      for (int k = 0; k < 3; ++k) fields.emplace_back(set.size());
      Field* of = &fields[fields.size() - 3];
      plan.velocity(of[0].u, of[0].v);
      plan.velocity({set.y, set.x, {}}, of[1].u, of[1].v);
      plan.velocity_bare({set.y, set.x}, of[2].u, of[2].v);
    }
    for (std::size_t k = 3; k < fields.size(); ++k) CHECK(fields[k] == fields[k % 3]);
  }
  omp_set_num_threads(threads);
}

TEST_CASE("either builder leads to the same velocities, and a plan may be asked again") {
  const test::PointSet set = test::make_points(test::PointKind::ringwake, 3000);
  const fmm::Sources blobs{set.x, set.y, set.gamma, {}};
  Field reverse(set.size()), forward(set.size()), again(set.size());
  const fmm::Plan plan(blobs, {.builder = fmm::Builder::reverse});
  plan.velocity(reverse.u, reverse.v);
  fmm::Plan(blobs, {.builder = fmm::Builder::forward}).velocity(forward.u, forward.v);
  plan.velocity(again.u, again.v);
  CHECK(reverse == forward);
  CHECK(reverse == again);
}

TEST_CASE("asked at its own blobs' places as targets, a plan gives the same velocities") {
  const auto length = [](const Field& a) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.u.size(); ++i) sum += a.u[i] * a.u[i] + a.v[i] * a.v[i];
    return std::sqrt(sum);
  };
  const test::PointSet set = test::make_points(test::PointKind::uniform, 2000);
  const std::vector<double> sigma = varied_cores(set.size());
  for (const fmm::Cores cores : {fmm::Cores::source, fmm::Cores::mean}) {
    const fmm::Sources blobs{set.x, set.y, set.gamma, sigma};
    Field own(set.size()), asked(set.size());
    const fmm::Plan boxes(blobs, {.cores = cores, .method = fmm::SumMethod::boxes});
    boxes.velocity(own.u, own.v);
    boxes.velocity({set.x, set.y, sigma}, asked.u, asked.v);
    CHECK(own == asked);
    const fmm::Plan plan(blobs, {.tolerance = 1e-9, .cores = cores});
    plan.velocity(own.u, own.v);
    plan.velocity({set.x, set.y, sigma}, asked.u, asked.v);
    Field difference = own;
    for (std::size_t i = 0; i < set.size(); ++i) {
      difference.u[i] -= asked.u[i], difference.v[i] -= asked.v[i];
    }
    CHECK(length(difference) < 2e-9 * length(own));
  }
}

TEST_CASE("velocities scale with gamma and with length, to the last bit for powers of two") {
  test::PointSet set = test::make_points(test::PointKind::hard, 2000);
  std::vector<double> sigma = varied_cores(set.size());
  Field before(set.size()), after(set.size());
  fmm::Plan({set.x, set.y, set.gamma, sigma}, {}).velocity(before.u, before.v);
  for (std::size_t i = 0; i < set.size(); ++i) {
    set.x[i] *= 0x1p-300, set.y[i] *= 0x1p-300, sigma[i] *= 0x1p-300, set.gamma[i] *= 0x1p-400;
  }
  fmm::Plan({set.x, set.y, set.gamma, sigma}, {}).velocity(after.u, after.v);
  for (double& u : after.u) u *= 0x1p100;
  for (double& v : after.v) v *= 0x1p100;
  CHECK(before == after);
}

TEST_CASE("work counted adds up: every target meets every source once") {
  const test::PointSet set = test::make_points(test::PointKind::uniform, 500);
  const std::vector<double> sigma(set.size(), 10.0);
  const fmm::Plan plan({set.x, set.y, set.gamma, sigma}, {});
  const fmm::Work work = plan.work();
  CHECK(work.series == 0);
  CHECK(work.terms == 0);
  CHECK(work.bare == 0);
  CHECK(work.cored == 500 * 500);
  CHECK(plan.bytes() > 500 * 4 * sizeof(double));
}
