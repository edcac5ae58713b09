#include <catch2/catch.hpp>

#include "body/shapes/circle.hpp"
#include "vortex/cylinder_flow.hpp"
#include "vortex/flows.hpp"

using namespace vortree;
using test::Complex;
using vortex::FoldedBlobs;
using vortex::Wall;

namespace {

constexpr double radius = 0.5;

Wall wall_of(int panels) {
  return Wall(body::circle({}, radius), panels);
}

FoldedBlobs vortex_at(Complex z) {
  return {{z.real()}, {z.imag()}, {0.01}};
}

std::vector<double> slip_of_vortex(const Wall& wall, Complex z0) {
  const FoldedBlobs at = vortex_at(z0);
  const std::vector<double> one{1.0};
  return wall.slip({}, test::sampled(wall, at, one), at, one);
}

double sum_of(const std::vector<double>& values) {
  double sum = 0;
  for (double value : values) sum += value;
  return sum;
}

/// The largest that a sheet differs from the exact swirl at the panels' middles.
double error(const Wall& wall, const std::vector<double>& sheet, Complex z0, double bound) {
  double largest = 0;
  for (std::size_t i = 0; i < wall.panels(); ++i) {
    const Complex z = test::complex(wall.middle(i));
    const double exact = test::swirl(test::vortex_beside(radius, z0, bound, z), z);
    largest = std::max(largest, std::abs(sheet[i] - exact));
  }
  return largest;
}

/// Average along the arc of panel i of a unit vortex's tangential velocity, in many small steps.
double average_on_arc(const Wall& wall, std::size_t i, Complex z0) {
  constexpr int steps = 20000;
  const double b = wall.panel_length(0);
  double turned = 0;
  Complex before = test::complex(wall.shape().point(i * b)) - z0;
  for (int k = 1; k <= steps; ++k) {
    const Complex now = test::complex(wall.shape().point((i + k / double{steps}) * b)) - z0;
    turned += std::arg(now / before);
    before = now;
  }
  return turned / (2 * std::numbers::pi * b);
}

}  // namespace

TEST_CASE("a linear system solved by hand is solved, pivot on the diagonal or not") {
  const vortex::LinearSystem system(std::vector<double>{0, 2, 1, 1, -1, 0, 3, 0, 2}, 3);
  for (int again = 0; again < 2; ++again) {
    const auto x = system.solve(std::vector<double>{7, -1, 9});  // x = (1, 2, 3)
    for (int k = 0; k < 3; ++k) CHECK(x[k] == Approx(k + 1).epsilon(1e-14));
  }
}

TEST_CASE("a linear system of random numbers gives back what it was made of") {
  test::Uniform uniform(3);
  constexpr std::size_t n = 100;
  std::vector<double> matrix(n * n), x(n), right(n);
  for (double& a : matrix) a = uniform() - 0.5;
  for (double& a : x) a = uniform() - 0.5;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) right[i] += matrix[i * n + j] * x[j];
  const auto solved = vortex::LinearSystem(matrix, n).solve(right);
  for (std::size_t i = 0; i < n; ++i) CHECK(std::abs(solved[i] - x[i]) < 1e-11);
}

TEST_CASE("a wall of fewer than 8 panels and a circle without a radius are turned away") {
  CHECK_THROWS_AS(wall_of(7), std::invalid_argument);
  CHECK_THROWS_AS(body::circle({}, 0), std::invalid_argument);
  CHECK_THROWS_AS(body::circle({}, -1), std::invalid_argument);
}

TEST_CASE("on a circle, arc, distance, normal and curvature are the polar ones") {
  const auto shape = body::circle({1, 2}, radius);
  for (double theta : {0.0, 1.0, 3.0, 4.0, 6.2}) {
    const body::WallPoint at =
        shape->nearest({1 + 0.7 * std::cos(theta), 2 + 0.7 * std::sin(theta)});
    CHECK(at.arc == Approx(theta * radius).margin(1e-14));
    CHECK(at.distance == Approx(0.2).epsilon(1e-14));
    CHECK(at.curvature == 2);
    CHECK(std::hypot(at.normal.x - std::cos(theta), at.normal.y - std::sin(theta)) < 1e-14);
    CHECK(std::hypot(at.tangent().x + std::sin(theta), at.tangent().y - std::cos(theta)) < 1e-14);
  }
  CHECK(shape->nearest({1, 2.3}).distance == Approx(-0.2).epsilon(1e-14));
}

TEST_CASE("the bare stream past a circle calls for the sheet -2 U sin theta") {
  for (int panels : {8, 33, 200}) {
    const Wall wall = wall_of(panels);
    const auto sheet = test::sheet_of_stream(wall);
    for (std::size_t i = 0; i < wall.panels(); ++i)
      CHECK(std::abs(sheet[i] + 2 * std::sin(test::polar_angle(wall.middle(i)))) < 1e-12);
  }
}

TEST_CASE("the sheet's total circulation is what was asked for, to round-off") {
  const Wall wall = wall_of(100);
  for (double total : {0.0, -1.0, 3.7})
    for (double r : {0.5001, 0.52, 0.8}) {
      const auto sheet = wall.sheet(slip_of_vortex(wall, std::polar(r, 2.1)), total);
      CHECK(std::abs(sum_of(sheet) * wall.panel_length(0) - total) < 1e-14);
    }
}

TEST_CASE("given a vortex's exact slip, the sheet is the images' to spectral accuracy") {
  const Complex z0 = std::polar(0.75, 0.4);
  double before = 1;
  for (int panels : {16, 32, 64, 128}) {
    const Wall wall = wall_of(panels);
    std::vector<double> slip;
    for (std::size_t i = 0; i < wall.panels(); ++i) {
      const Complex z = test::complex(wall.middle(i));
      slip.push_back(test::swirl(1.0 / (2 * std::numbers::pi * test::i_unit * (z - z0)), z));
    }
    const double now = error(wall, wall.sheet(slip, -1), z0, -1);
    CHECK(now < std::max(before * before * 5, 1e-13));  // twice the panels, twice the digits
    before = now;
  }
  CHECK(before < 1e-13);
}

TEST_CASE("by a vortex's average slip, the sheet comes to the images' in second order") {
  const Complex z0 = std::polar(1.0, 0.4);
  const auto at = [&](int panels) {
    const Wall wall = wall_of(panels);
    return error(wall, wall.sheet(slip_of_vortex(wall, z0), -1), z0, -1);
  };
  const double coarse = at(64), fine = at(128);
  CHECK(fine < 2.5e-4);
  CHECK(std::log2(coarse / fine) == Approx(2).margin(0.1));
}

TEST_CASE("the slip of a vortex near the wall is its exact average over each panel, however near") {
  const Wall wall = wall_of(64);
  const double b = wall.panel_length(0);
  for (double distance : {1e-6, 1e-3, 0.1, 1.0, 2.9}) {
    for (double along : {10.5, 11.0, 63.9}) {
      const Complex z0 = std::polar(radius + distance * b, along * b / radius);
      const auto slip = slip_of_vortex(wall, z0);
      for (int k = -4; k <= 4; ++k) {
        const std::size_t i = (static_cast<std::size_t>(along) + 64 + k) % 64;
        CHECK(std::abs(slip[i] - average_on_arc(wall, i, z0)) < 1e-10 / b);
      }
    }
  }
}

TEST_CASE("the sheet of a vortex very near is the average of the images' over each panel") {
  const Wall wall = wall_of(64);
  const double b = wall.panel_length(0);
  for (double distance : {0.01, 0.3, 2.9}) {
    const Complex z0 = std::polar(radius + distance * b, 1.0);
    const Complex image = radius * radius / std::conj(z0);
    const auto sheet = wall.sheet(slip_of_vortex(wall, z0), -1);
    for (int i = 4; i <= 16; ++i) {  // around panel 10, where the sheet reaches 1/b
      const double exact = average_on_arc(wall, i, z0) - average_on_arc(wall, i, image);
      CHECK(std::abs(sheet[i] - exact) < 1e-5 / b);
    }
  }
}

TEST_CASE("slip and sheet are the same bits for any number of threads") {
  const Wall wall = wall_of(100);
  const vortex::Blobs blobs = test::layer(3000, radius, 0.1, 0.01, 0.02);
  const FoldedBlobs at = fold(blobs, &wall.shape());
  const auto u = test::sampled(wall, at, blobs.gamma);
  const auto sheet = [&] { return wall.sheet(wall.slip({1, 0}, u, at, blobs.gamma), 0); };
  const auto once = test::with_threads(1, sheet);
  for (int threads : {2, 3}) CHECK(once == test::with_threads(threads, sheet));
}
