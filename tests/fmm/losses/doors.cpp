#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "fmm/direct.hpp"
#include "fmm/plan.hpp"

using namespace vortree;
using Catch::Matchers::Contains;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
const std::vector<double> three{1, 2, 3}, two{1, 2};

void make(const std::vector<double>& x, const std::vector<double>& y,
          const std::vector<double>& gamma, const std::vector<double>& sigma,
          fmm::Options options = {}) {
  fmm::Plan plan({x, y, gamma, sigma}, options);
}

}  // namespace

TEST_CASE("blobs that cannot be summed are refused by name, index and value") {
  CHECK_THROWS_WITH(make(three, two, three, {}), Contains("y has 2 values, x has 3"));
  CHECK_THROWS_WITH(make(three, three, two, {}), Contains("gamma has 2 values, x has 3"));
  CHECK_THROWS_WITH(make(three, three, three, two), Contains("sigma has 2 values, x has 3"));
  CHECK_THROWS_WITH(make({1, no_number, 3}, three, three, {}), Contains("x[1] is nan"));
  CHECK_THROWS_WITH(make(three, {1, 2, -inf}, three, {}), Contains("y[2] is -inf"));
  CHECK_THROWS_WITH(make(three, three, {inf, 2, 3}, {}), Contains("gamma[0] is inf"));
  CHECK_THROWS_WITH(make(three, three, three, {1, -0.5, 3}), Contains("sigma[1] is -0.5"));
  CHECK_THROWS_AS(make(three, three, three, {1, no_number, 3}), std::invalid_argument);
}

TEST_CASE("options out of range are refused with their value") {
  CHECK_THROWS_WITH(make(three, three, three, {}, {.tolerance = 0}), Contains("tolerance is 0"));
  CHECK_THROWS_WITH(make(three, three, three, {}, {.tolerance = 1}), Contains("tolerance is 1"));
  CHECK_THROWS_AS(make(three, three, three, {}, {.tolerance = no_number}), std::invalid_argument);
  CHECK_THROWS_WITH(make(three, three, three, {}, {.order = -1}), Contains("order is -1"));
  CHECK_THROWS_WITH(make(three, three, three, {}, {.order = 201}), Contains("order is 201"));
  CHECK_THROWS_WITH(make(three, three, three, {}, {.finest_level = 32}),
                    Contains("finest_level is 32"));
}

TEST_CASE("targets and results that do not fit are refused") {
  const fmm::Sources blobs{three, three, three, {}};
  const fmm::Plan plan(blobs, {});
  std::vector<double> u(3), v(3), few(2);
  CHECK_THROWS_WITH(plan.velocity(few, v), Contains("u has 2 values and v 3; both must have 3"));
  CHECK_THROWS_WITH(plan.velocity({three, two, {}}, u, v), Contains("y has 2 values, x has 3"));
  CHECK_THROWS_WITH(plan.velocity({three, three, two}, u, v), Contains("sigma has 2"));
  CHECK_THROWS_WITH(plan.velocity({two, two, {}}, u, v), Contains("both must have 2"));
  const std::vector<double> broken{1, no_number, 3};
  CHECK_THROWS_WITH(plan.velocity_bare({broken, three}, u, v), Contains("x[1] is nan"));
  CHECK_THROWS_WITH(fmm::velocity_direct(blobs, {three, broken, {}}, fmm::Cores::source, u, v),
                    Contains("y[1] is nan"));
  CHECK_THROWS_WITH(fmm::velocity_direct(blobs, {three, three, {}}, fmm::Cores::mean, few, v),
                    Contains("u has 2 values"));
}

TEST_CASE("blobs whose distances doubles cannot resolve are refused by every method") {
  const std::vector<double> far{0.25, 0.5, 1e80}, near{0, 1e-70, 1}, zero{0, 0, 0};
  const std::vector<double> narrow{1, 1e-70, 1};
  std::vector<double> u(3), v(3), w(3);
  for (const fmm::SumMethod method : {fmm::SumMethod::fmm, fmm::SumMethod::boxes}) {
    CHECK_THROWS_WITH(make(far, zero, three, {}, {.method = method}),
                      Contains("blobs 0 and 1 are 0.25 apart"));
    CHECK_THROWS_WITH(make(near, zero, three, {}, {.method = method}),
                      Contains("blobs 0 and 1 are 1e-70 apart"));
    CHECK_THROWS_WITH(make({1, 2, 1.7e308}, three, three, {}, {.method = method}),
                      Contains("x[2] is 1.7e+308"));
    CHECK_THROWS_WITH(make(three, three, three, {1e80, 1e80, 1e80}, {.method = method}),
                      Contains("sigma[0] is 1e+80"));
    CHECK_NOTHROW(make({0.25, 0.25, 1e80}, zero, three, {}, {.method = method}));
    CHECK_NOTHROW(make({1e-70, 0.5, 1}, {1e-80, 2, 3}, three, {}, {.method = method}));
    const fmm::Plan plan({three, three, three, narrow}, {.method = method});
    const fmm::Targets targets{three, three, {}};
    CHECK_THROWS_WITH(plan.gradient(targets, u, v, w), Contains("sigma[1] is 1e-70"));
    CHECK_THROWS_WITH(plan.velocity_and_gradient(u, v, u, v, w), Contains("sigma[1] is 1e-70"));
    CHECK_THROWS_WITH(plan.stream_function(targets, w), Contains("sigma[1] is 1e-70"));
  }
  const auto direct = [&](const std::vector<double>& x) {
    fmm::velocity_direct({x, zero, three, {}}, {x, zero, {}}, fmm::Cores::source, u, v);
  };
  CHECK_THROWS_WITH(direct(far), Contains("apart"));
  CHECK_THROWS_WITH(direct({1, 2, 1.7e308}), Contains("x[2]"));
}

TEST_CASE(
    "velocities that a double cannot hold in the user's units are refused, others are right") {
  const std::vector<double> x{0, 1e-150}, y{0, 0}, far_x{3e300, 1}, far_y{4e300, 1};
  std::vector<double> u(2), v(2);
  for (const double gamma : {1e200, 1e-200}) {
    const std::vector<double> strengths{gamma, gamma};
    const std::vector<double> scaled{0, gamma > 1 ? 1e-150 : 1e150};
    for (const fmm::SumMethod method : {fmm::SumMethod::fmm, fmm::SumMethod::boxes}) {
      const fmm::Plan plan({scaled, y, strengths, {}}, {.method = method});
      CHECK_THROWS_WITH(plan.velocity(u, v), Contains("a double cannot hold"));
    }
    CHECK_THROWS_WITH(
        fmm::velocity_direct({scaled, y, strengths, {}}, {scaled, y, {}}, fmm::Cores::source, u, v),
        Contains("a double cannot hold"));
  }
  // Beyond 1e70 extents there is one vortex of all circulation: |u| = 6/(2 pi 5e300).
  for (const fmm::SumMethod method : {fmm::SumMethod::fmm, fmm::SumMethod::boxes}) {
    fmm::Plan({three, three, three, {}}, {.method = method}).velocity({far_x, far_y, {}}, u, v);
    CHECK(u[0] == Approx(-6 / (2 * std::numbers::pi) * 0.8 / 5e300).epsilon(1e-14));
    CHECK(v[0] == Approx(6 / (2 * std::numbers::pi) * 0.6 / 5e300).epsilon(1e-14));
  }
}

TEST_CASE("under wide cores blobs may be as near to each other as they like") {
  // Two of a cloud so near at the x axis, against the same two in one place.
  std::vector<double> x, y, gamma, sigma;
  for (int i = 0; i < 400; ++i) {
    x.push_back(std::sin(1.0 + 37 * i));
    y.push_back(std::cos(2.0 + 53 * i));
    gamma.push_back(i % 3 - 0.9);
    sigma.push_back(0.05 + 0.001 * (i % 7));
  }
  x[17] = x[250] = 0.3, y[17] = y[250] = 0;
  using Sums = std::vector<std::vector<double>>;
  const auto sums = [&](double apart, fmm::SumMethod method, double tolerance) {
    std::vector<double> shifted = y;
    shifted[250] = apart;
    const fmm::Plan plan({x, shifted, gamma, sigma}, {.tolerance = tolerance, .method = method});
    Sums all(7, std::vector<double>(x.size()));
    plan.velocity(all[0], all[1]);
    plan.velocity_and_gradient(all[0], all[1], all[2], all[3], all[4]);
    plan.stream_function(fmm::Targets{x, shifted, {}}, all[5]);
    if (method != fmm::SumMethod::direct)  // which knows of no cores then
      plan.velocity_bare({std::span(x).first(16), std::span(y).first(16)},
                         std::span(all[6]).first(16), std::span(all[6]).subspan(16, 16));
    return all;
  };
  for (const fmm::SumMethod method :
       {fmm::SumMethod::fmm, fmm::SumMethod::boxes, fmm::SumMethod::direct})
    for (const double tolerance : {1e-3, 1e-6, 1e-12}) {
      const Sums in_one_place = sums(0, method, tolerance);
      for (const double apart : {1e-60, 2e-69, 1e-100, 1e-160, 1e-290}) {
        const Sums found = sums(apart, method, tolerance);
        double off = 0;
        for (std::size_t k = 0; k < found.size(); ++k)
          for (std::size_t i = 0; i < x.size(); ++i)
            if (!(std::abs(found[k][i] - in_one_place[k][i]) <= off))
              off = std::abs(found[k][i] - in_one_place[k][i]);
        CAPTURE(static_cast<int>(method), tolerance, apart);
        // What moves is round-off, of sums of a hundred at most.
        CHECK(off < 1e-4 * tolerance + 1e-11);
      }
    }
}
