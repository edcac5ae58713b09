#include "sph/motion/edge_filter.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "sph/boundary/outer_box.hpp"
#include "sph/operators/clouds.hpp"

using namespace vortree;
using namespace vortree::sph;
using namespace vortree::sph::test;

namespace {

struct Edged {
  Cloud cloud;
  Stencils stencils;
  std::vector<Slopes> slopes;

  OperatorOptions options;

  explicit Edged(const auto& velocity, const OperatorOptions& with = {})
      : cloud(uneven_cloud(16, 91, 0.1, false)), options(with) {
    std::int32_t number = 0;
    for (const BoundaryNode& node : box_nodes({{0, 0}, {1, 1}}, 1.0 / 16))
      cloud.add(node, ParticleKind::outer, number++);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const Vec2 u = velocity(cloud, i);
      cloud.u[i] = cloud.u_before[i] = u.x, cloud.v[i] = cloud.v_before[i] = u.y;
      cloud.p[i] = u.x;
    }
    stencils.renew(cloud, options);
    find_slopes(cloud, stencils, slopes);
  }

  Cloud filtered(double share) const {
    Cloud copy = cloud;
    filter_edges(copy, stencils, slopes, options, share);
    return copy;
  }

  bool beside_edge(std::size_t i) const {
    bool found = false;
    stencils.for_each(
        i, [&](std::size_t j, std::size_t) { found |= cloud.kind[j] == ParticleKind::outer; });
    return found && cloud.free(i);
  }
};

}  // namespace

TEST_CASE("the filter beside the outer boundary leaves quadratic velocities as they are") {
  Chance chance(4);
  const Polynomial p(2, chance), q(2, chance);
  const Edged of([&](const Cloud& c, std::size_t i) { return Vec2{p(c.at(i)), q(c.at(i))}; });
  const Cloud after = of.filtered(0.3);
  for (std::size_t i = 0; i < after.size(); ++i) {
    CHECK(after.u[i] == Approx(of.cloud.u[i]).margin(1e-11));
    CHECK(after.v[i] == Approx(of.cloud.v[i]).margin(1e-11));
  }
}

TEST_CASE("the filter damps what alternates beside the outer boundary, and nothing else") {
  const Edged of([](const Cloud& c, std::size_t i) {
    const long column = static_cast<long>(c.x[i] * 16), row = static_cast<long>(c.y[i] * 16);
    return c.free(i) ? Vec2{(column + row) % 2 ? 1.0 : -1.0, 0} : Vec2{};
  });
  const Cloud after = of.filtered(0.3);
  double before_sum = 0, after_sum = 0;
  for (std::size_t i = 0; i < after.size(); ++i) {
    CHECK(after.p[i] == of.cloud.p[i]);
    if (!of.beside_edge(i)) {
      CHECK(after.u[i] == of.cloud.u[i]);
      continue;
    }
    before_sum += of.cloud.u[i] * of.cloud.u[i], after_sum += after.u[i] * after.u[i];
    CHECK(after.u_before[i] == after.u[i]);
  }
  CHECK(before_sum > 100);
  // By more than the tenth that motion/tuning.hpp says it may grow in a step.
  CHECK(std::sqrt(after_sum / before_sum) < 0.9);
}

TEST_CASE("rows that alternate beside the outer boundary grow by no operators") {
  const OperatorOptions options =
      GENERATE(OperatorOptions{}, OperatorOptions{4, 3.9},
               OperatorOptions{.reach = 3.9, .kind = OperatorKind::pair_sums});
  CAPTURE(options.degree, options.reach);
  const Edged of(
      [](const Cloud& c, std::size_t i) {
        return c.free(i) ? Vec2{static_cast<long>(c.y[i] * 16) % 2 ? 1.0 : -1.0, 0} : Vec2{};
      },
      options);
  const Cloud after = of.filtered(0.3);
  double before_sum = 0, after_sum = 0;
  for (std::size_t i = 0; i < after.size(); ++i) {
    if (after.u[i] == of.cloud.u[i]) continue;
    before_sum += of.cloud.u[i] * of.cloud.u[i], after_sum += after.u[i] * after.u[i];
  }
  CHECK(before_sum > 50);
  // 0.95 by fits, less by sums; where the series of degree 4 is taken off, they grow.
  CHECK(std::sqrt(after_sum / before_sum) < 0.97);
}

TEST_CASE("a share of nothing filters nothing") {
  const Edged of([](const Cloud&, std::size_t i) { return Vec2{i % 2 ? 1.0 : 0.0, 0}; });
  CHECK(of.filtered(0).u == of.cloud.u);
}
