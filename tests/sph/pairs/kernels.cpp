#include "sph/pairs/kernels.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "papers.hpp"

using namespace vortree;
using sph::every_kernel;
using sph::Kernel;

namespace {

// Integral over [a, b] by Gauss-Legendre with 10 points in each of 40 panels: exact to rounding for
// the pieces of these kernels, whose knots are whole numbers.
template <class F>
double integral(double a, double b, const F& f) {
  constexpr double at[5] = {0.1488743389816312, 0.4333953941292472, 0.6794095682990244,
                            0.8650633666889845, 0.9739065285171717};
  constexpr double weight[5] = {0.2955242247147529, 0.2692667193099963, 0.2190863625159820,
                                0.1494513491505806, 0.0666713443086881};
  const int panels = 40;
  double sum = 0;
  for (int p = 0; p < panels; ++p) {
    const double half = (b - a) / panels / 2, middle = a + (2 * p + 1) * half;
    for (int k = 0; k < 5; ++k) {
      sum += half * weight[k] * (f(middle - half * at[k]) + f(middle + half * at[k]));
    }
  }
  return sum;
}

// Of a ball's surface in d dimensions.
double surface(int d, double r) {
  using std::numbers::pi;
  return d == 1 ? 2 : d == 2 ? 2 * pi * r : 4 * pi * r * r;
}

}  // namespace

TEST_CASE("every kernel integrates to one in 1, 2 and 3 dimensions, at any h") {
  for (const Kernel kernel : every_kernel) {
    for (int d = 1; d <= 3; ++d) {
      for (const double h : {0.25, 1.0, 3.0}) {
        CAPTURE(sph::name_of(kernel), d, h);
        const double whole = integral(0, sph::support(kernel) * h, [&](double r) {
          return surface(d, r) * sph::value(kernel, d, r, h);
        });
        CHECK(whole == Approx(1).epsilon(1e-13));
      }
    }
  }
}

TEST_CASE("in the plane every kernel and its derivative are those of its paper") {
  // Some ten units of round-off of the larger of the two, which is about one; in the slope of
  // quintic_spline terms of 960 cancel to 66.
  constexpr double rounding = 1e-14;
  for (const Kernel kernel : every_kernel) {
    for (double r = 0.01; r < 4; r += 0.0101) {
      CAPTURE(sph::name_of(kernel), r);
      const double h = 1.3, reach = sph::support(kernel) * h;
      const test::Printed paper = test::printed(kernel, r, reach);
      REQUIRE(std::abs(sph::value(kernel, 2, r, h) - paper.value(reach)) < rounding);
      REQUIRE(std::abs(sph::derivative(kernel, 2, r, h) - paper.derivative(reach)) < rounding);
    }
  }
}

TEST_CASE("the derivative of every kernel is that of its value") {
  for (const Kernel kernel : every_kernel) {
    for (int d = 1; d <= 3; ++d) {
      for (double r = 0.03; r < sph::support(kernel); r += 0.0301) {
        CAPTURE(sph::name_of(kernel), d, r);
        const double e = 1e-5;
        const double slope =
            (sph::value(kernel, d, r + e, 1) - sph::value(kernel, d, r - e, 1)) / (2 * e);
        REQUIRE(sph::derivative(kernel, d, r, 1) == Approx(slope).margin(1e-8).epsilon(1e-7));
      }
    }
  }
}

TEST_CASE("every kernel falls from its middle on, and is zero from its support on") {
  for (const Kernel kernel : every_kernel) {
    for (int d = 1; d <= 3; ++d) {
      CAPTURE(sph::name_of(kernel), d);
      const double edge = sph::support(kernel);
      double before = sph::value(kernel, d, 0, 1);
      for (double r = 0.01; r < edge; r += 0.01) {
        const double now = sph::value(kernel, d, r, 1);
        REQUIRE(now < before);
        REQUIRE(now >= 0);
        REQUIRE(sph::derivative(kernel, d, r, 1) <= 0);
        before = now;
      }
      for (const double r : {edge, edge + 1e-9, 10.0}) {
        CHECK(sph::value(kernel, d, r, 1) == 0);
        CHECK(sph::derivative(kernel, d, r, 1) == 0);
      }
    }
  }
}

TEST_CASE("Wendland kernels are as smooth at their edge as their names say") {
  // C2k: value and first 2k derivatives vanish there, so W ~ (2 - q)^(2k + 1) at least.
  const std::pair<Kernel, int> smooth[] = {
      {Kernel::wendland_c2, 3}, {Kernel::wendland_c4, 5}, {Kernel::wendland_c6, 7}};
  for (const auto& [kernel, order] : smooth) {
    for (int d = 1; d <= 3; ++d) {
      const double near = sph::shape(kernel, d, 2 - 1e-3), nearer = sph::shape(kernel, d, 2 - 5e-4);
      CHECK(std::log2(near / nearer) > order - 0.01);
    }
  }
}

TEST_CASE("kernels are refused other dimensions") {
  CHECK_THROWS_WITH(sph::norm(Kernel::bell, 4), Catch::Matchers::Contains("4 dimensions"));
}
