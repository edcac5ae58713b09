#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "fmm/plan.hpp"
#include "fmm/reference.hpp"
#include "fmm/series/order.hpp"
#include "point_sets.hpp"

using namespace vortree;

namespace {

/// Largest error over the local sum of |contributions|, for each fixed order from 1 on.
std::vector<test::Error> errors_by_order(test::PointKind kind, std::size_t n, int most) {
  const test::PointSet set = test::make_points(kind, n);
  const fmm::Sources blobs{set.x, set.y, set.gamma, {}};
  const std::vector<double> x = test::every(n / 400, set.x), y = test::every(n / 400, set.y);
  const fmm::Targets targets{x, y, {}};
  const test::Exact exact = test::exact_velocity(blobs, targets, fmm::Cores::source);
  std::vector<test::Error> errors;
  std::vector<double> u(x.size()), v(x.size());
  for (int order = 1; order <= most; ++order) {
    fmm::Plan(blobs, {.order = order, .capacity = 20, .method = fmm::SumMethod::boxes})
        .velocity(targets, u, v);
    errors.push_back(test::error_of(u, v, exact));
  }
  return errors;
}

}  // namespace

TEST_CASE("box-to-point errors fall with the order as theory says, down to round-off") {
  for (const test::PointKind kind : test::every_kind) {
    CAPTURE(test::kind_names[static_cast<int>(kind)]);
    const std::vector<test::Error> errors = errors_by_order(kind, 8000, 46);
    const double theta = fmm::one_cell_apart;
    for (int order = 1; order <= 46; ++order) {
      CAPTURE(order);
      const double bound = std::pow(theta, order) * (1 + theta) / (1 - theta);
      CHECK(errors[static_cast<std::size_t>(order - 1)].largest < bound + 1e-15);
    }
    const double slope = std::pow(errors[29].relative_l2 / errors[4].relative_l2, 1.0 / 25);
    CHECK(slope > 0.38);
    CHECK(slope < theta);
    CHECK(errors[45].relative_l2 < 5e-15);
  }
}
