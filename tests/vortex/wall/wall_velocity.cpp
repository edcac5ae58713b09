#include <catch2/catch.hpp>

#include "body/shapes/circle.hpp"
#include "vortex/cylinder_flow.hpp"

using namespace vortree;
using test::Complex;
using vortex::Wall;

namespace {

constexpr double radius = 0.5;

Wall wall_of(int panels) {
  return Wall(body::circle({}, radius), panels);
}

/// Points all around at a distance from the wall, at all places along the panels.
std::vector<Complex> ring(double distance) {
  constexpr int count = 999;
  std::vector<Complex> z;
  for (int k = 0; k < count; ++k)
    z.push_back(std::polar(radius + distance, 2 * std::numbers::pi * (k + 0.37) / count));
  return z;
}

/// u - i v of a sheet, as the wall gives it.
std::vector<Complex> velocity(const Wall& wall, const std::vector<double>& sheet,
                              const std::vector<Complex>& at) {
  std::vector<double> x, y;
  for (Complex z : at) {
    x.push_back(z.real());
    y.push_back(z.imag());
  }
  vortex::Velocities u(at.size());
  wall.add_velocity(sheet,
                    fmm::Options{.cores = fmm::Cores::source, .method = fmm::SumMethod::direct},
                    {x, y}, u);
  std::vector<Complex> w;
  for (std::size_t k = 0; k < at.size(); ++k) w.emplace_back(u.u[k], -u.v[k]);
  return w;
}

/// The largest error of stream and sheet on a ring, a number of panel lengths from the wall.
double stream_error(int panels, double lengths) {
  const Wall wall = wall_of(panels);
  const auto at = ring(lengths * wall.panel_length(0));
  const auto w = velocity(wall, test::sheet_of_stream(wall), at);
  double largest = 0;
  for (std::size_t k = 0; k < at.size(); ++k)
    largest = std::max(largest, std::abs(1.0 + w[k] - test::stream_past(radius, at[k])));
  return largest;
}

/// u - i v at z of a straight sheet of strength 1 from a to b, by Simpson's rule.
Complex quadrature(Complex z, Complex a, Complex b) {
  constexpr int n = 4000;
  Complex sum = 0;
  for (int k = 0; k <= n; ++k) {
    const double weight = k == 0 || k == n ? 1 : k % 2 ? 4 : 2;
    sum += weight / (z - (a + (k / double{n}) * (b - a)));
  }
  return sum * std::abs(b - a) / (3.0 * n) / (2 * std::numbers::pi * test::i_unit);
}

}  // namespace

TEST_CASE("stream and sheet leave the body's interior at rest") {
  const Wall wall = wall_of(128);
  const auto sheet = test::sheet_of_stream(wall);
  for (double r : {0.0, 0.1, 0.3, 0.35}) {
    for (double theta : {0.1, 1.6, 4.0}) {
      const Complex z = std::polar(r, theta);
      Complex w = 1;
      for (std::size_t i = 0; i < wall.panels(); ++i)
        w += sheet[i] * wall.panel_length(0) /
             (2 * std::numbers::pi * test::i_unit * (z - test::complex(wall.middle(i))));
      CHECK(std::abs(w) < 1e-12);
    }
  }
}

TEST_CASE("a vortex and its sheet leave the interior at rest, to second order in the panels") {
  const Complex z0 = std::polar(0.8, 2.0);
  const vortex::FoldedBlobs at{{z0.real()}, {z0.imag()}, {0.01}};
  const std::vector<double> one{1.0};
  const auto inside = [&](int panels) {
    const Wall wall = wall_of(panels);
    const auto sheet = wall.sheet(wall.slip({}, test::sampled(wall, at, one), at, one), -1);
    const Complex z = std::polar(0.2, 1.5);
    Complex w = 1.0 / (z - z0);
    for (std::size_t i = 0; i < wall.panels(); ++i)
      w += sheet[i] * wall.panel_length(0) / (z - test::complex(wall.middle(i)));
    return std::abs(w) / (2 * std::numbers::pi);
  };
  CHECK(inside(128) < 1e-4);
  CHECK(std::log2(inside(64) / inside(128)) == Approx(2).margin(0.1));
}

TEST_CASE("far from the wall stream and sheet are the potential flow 1 - R^2/z^2 to round-off") {
  const Wall wall = wall_of(128);
  const auto sheet = test::sheet_of_stream(wall);
  for (double distance : {0.2, 0.5, 3.0}) {
    const auto at = ring(distance);
    const auto w = velocity(wall, sheet, at);
    for (std::size_t k = 0; k < at.size(); k += 7)
      CHECK(std::abs(1.0 + w[k] - test::stream_past(radius, at[k])) < 1e-13);
  }
}

TEST_CASE("beyond three panels from the wall the flow errs by no more than 4 exp(-6 pi)") {
  for (int panels : {64, 128, 256})
    CHECK(stream_error(panels, 3.001) < 4 * std::exp(-6 * std::numbers::pi) + 1e-7);
}

TEST_CASE("within three panels of the wall the flow is the potential flow to first order") {
  const double b = 2 * std::numbers::pi * radius / 128;
  CHECK(stream_error(128, 0.001) < 4 * b);  // the corners of constant panels: U b log(distance/b)
  CHECK(stream_error(128, 0.1) < 0.6 * b);
  CHECK(stream_error(128, 1) < 0.06 * b);
  for (double lengths : {0.001, 0.1})
    CHECK(std::log2(stream_error(64, lengths) / stream_error(128, lengths)) ==
          Approx(1).margin(0.15));
}

TEST_CASE("no fluid passes the wall: averaged over a panel, to first order") {
  const auto passing = [](int panels) {
    const Wall wall = wall_of(panels);
    constexpr int count = 200;
    double largest = 0;
    const auto sheet = test::sheet_of_stream(wall);
    for (int i = 0; i < panels; i += panels / 8) {
      std::vector<Complex> at;
      for (int k = 0; k < count; ++k)
        at.push_back(std::polar(radius * (1 + 1e-9),
                                (i + (k + 0.5) / count) * wall.panel_length(0) / radius));
      const auto w = velocity(wall, sheet, at);
      double sum = 0;
      for (int k = 0; k < count; ++k) sum += ((1.0 + w[k]) * at[k] / std::abs(at[k])).real();
      largest = std::max(largest, std::abs(sum / count));
    }
    return largest;
  };
  const double coarse = passing(128), fine = passing(256);
  CHECK(fine < 3e-4);
  CHECK(std::log2(coarse / fine) == Approx(1).margin(0.15));
}

TEST_CASE("the velocity of a near panel is its integral, of a far one its vortex's") {
  const Wall wall = wall_of(64);
  const double b = wall.panel_length(0);
  std::vector<double> sheet(64);
  sheet[20] = 1;
  const Complex a = test::complex(wall.shape().point(20 * b));
  const Complex e = test::complex(wall.shape().point(21 * b));
  const auto place = [&](double along, double distance) {
    return std::polar(radius + distance * b, along * b / radius);
  };
  const std::vector<Complex> near{place(20.5, 0.1), place(20.1, 0.05), place(20.9, 1),
                                  place(21.5, 0.2), place(16.5, 2.9),  place(26.4, 0.1)};
  const auto w = velocity(wall, sheet, near);
  for (std::size_t k = 0; k < near.size(); ++k)
    CHECK(std::abs(w[k] - quadrature(near[k], a, e)) < 1e-11);
  // As disc_multipole.hpp promises, where it serves.
  const std::vector<Complex> far{place(20.5, 3.1), place(40, 0.1), place(5, 1), place(20, 50)};
  const auto v = velocity(wall, sheet, far);
  for (std::size_t k = 0; k < far.size(); ++k) {
    const Complex z = far[k] - test::complex(wall.middle(20));
    const double promised = 1e-10 * b / (2 * std::numbers::pi * std::abs(far[k]));
    CHECK(std::abs(v[k] - b / (2 * std::numbers::pi * test::i_unit * z)) < promised);
  }
}

TEST_CASE("the velocity of a sheet is added to what was there, and the same by boxes") {
  const Wall wall = wall_of(128);
  const auto sheet = test::sheet_of_stream(wall);
  const std::vector<double> x{0.6, 0.0, -2, 0.501}, y{0.1, 0.53, 1, 0};
  vortex::Velocities direct(4), boxes(4);
  for (auto* u : {&direct, &boxes}) u->u = {5, 6, 7, 8};
  wall.add_velocity(sheet,
                    fmm::Options{.cores = fmm::Cores::source, .method = fmm::SumMethod::direct},
                    {x, y}, direct);
  wall.add_velocity(sheet, fmm::Options{.tolerance = 1e-10, .method = fmm::SumMethod::boxes},
                    {x, y}, boxes);
  for (std::size_t k = 0; k < 4; ++k) {
    const auto alone = velocity(wall, sheet, {{x[k], y[k]}});
    CHECK(direct.u[k] == Approx(5 + k + alone[0].real()).epsilon(1e-14));
    CHECK(std::abs(boxes.u[k] - direct.u[k]) < 1e-9);
    CHECK(std::abs(boxes.v[k] - direct.v[k]) < 1e-9);
  }
}

TEST_CASE("the first moment of the sheet of a stream U is that of its dipole, (0, -2 pi R^2 U)") {
  const Wall wall = wall_of(40);
  const Vec2 moment = wall.first_moment(test::sheet_of_stream(wall));
  CHECK(std::abs(moment.x) < 1e-13);
  CHECK(moment.y == Approx(-2 * std::numbers::pi * radius * radius).epsilon(1e-13));
}
