#include <catch2/catch.hpp>

#include "body/outlines/panel_limits.hpp"
#include "body/shapes/ellipse.hpp"
#include "body/shapes/joukowski.hpp"
#include "vortex/cylinder_flow.hpp"
#include "vortex/wall/forces.hpp"

using namespace vortree;
using test::Complex;
using vortex::FoldedBlobs;
using vortex::Wall;

namespace {

constexpr double a = 0.5, b = 0.01, incidence = 0.5235987755982988;  // 30 degrees
const Complex stream = std::polar(1.0, incidence);

std::shared_ptr<const body::Shape> thin() {
  return body::ellipse({}, a, b, 0);
}

/// u - i v past the ellipse without circulation: z = w + c^2/w, c^2 = (a^2 - b^2)/4, of the circle
/// of radius (a + b)/2.
Complex past_ellipse(Complex z) {
  const double radius = (a + b) / 2, c2 = (a * a - b * b) / 4;
  Complex w = (z + std::sqrt(z * z - 4 * c2)) / 2.0;
  if (std::abs(w) < std::abs(z - w)) w = z - w;
  return (std::conj(stream) - stream * radius * radius / (w * w)) / (1.0 - c2 / (w * w));
}

std::vector<double> sheet_of(const Wall& wall) {
  return wall.sheet(wall.slip(test::vec2(stream), vortex::Velocities(2 * wall.panels()), {}, {}),
                    0);
}

/// The largest error of the ellipse's sheet, as a share of the largest that it is.
double error(const Wall& wall) {
  const auto sheet = sheet_of(wall);
  double off = 0, most = 0;
  for (std::size_t i = 0; i < wall.panels(); ++i) {
    const Complex z = test::complex(wall.middle(i)), t = test::complex(wall.tangent(i));
    const double exact = (past_ellipse(z) * t).real();
    off = std::max(off, std::abs(sheet[i] - exact));
    most = std::max(most, std::abs(exact));
  }
  return off / most;
}

Wall even(const std::shared_ptr<const body::Shape>& shape, int panels) {
  return Wall({{shape, panels, {}, body::Grading(shape->perimeter(), panels)}});
}

std::vector<double> slip_of_vortex(const Wall& wall, Complex z0) {
  const FoldedBlobs at{{z0.real()}, {z0.imag()}, {0.01}};
  const std::vector<double> one{1.0};
  return wall.slip({}, test::sampled(wall, at, one), at, one);
}

double around(const Wall& wall, const std::vector<double>& values) {
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i) sum += values[i] * wall.panel_length(i);
  return sum;
}

}  // namespace

TEST_CASE("262 graded panels resolve an ellipse of 50 : 1, which 2000 even ones do not") {
  CHECK(body::PanelLimits(*thin()).needed() == Approx(262).margin(1));
  CHECK(error(Wall(thin(), 262)) < 1e-3);
  CHECK(error(even(thin(), 2000)) > 0.1);
}

TEST_CASE("with more graded panels the sheet of a thin ellipse is better by any power") {
  const double coarse = error(Wall(thin(), 262)), fine = error(Wall(thin(), 524)),
               finest = error(Wall(thin(), 786));
  CAPTURE(coarse, fine, finest);
  CHECK(fine < coarse / 8);  // of third order at least, and then more
  CHECK(finest < fine / 8);
}

TEST_CASE("the sheet's circulation is what was asked for, and no vortex leaves any on the wall") {
  const Wall wall(thin(), 300);
  for (const Complex z0 : {Complex{0.5005, 0.0001}, Complex{0.49, 0.01}, Complex{0, 0.012}}) {
    const auto slip = slip_of_vortex(wall, z0);
    // Two Gauss points miss 24/4320/3^4 = 7e-5 of an angle three panels away.
    CHECK(std::abs(around(wall, slip)) < 3e-4);
    CHECK(std::abs(around(wall, wall.sheet(slip, -0.7)) + 0.7) < 1e-12);
  }
}

TEST_CASE("graded panels of one circulation leave the inside of a thin ellipse at rest") {
  const Wall wall(thin(), 400);
  const auto sheet = sheet_of(wall);
  const std::vector<double> x{-0.45, -0.2, 0, 0.3, 0.48}, y(5);
  vortex::Velocities u(5);
  wall.add_velocity(sheet, {.cores = fmm::Cores::source, .method = fmm::SumMethod::direct}, {x, y},
                    u);
  for (std::size_t k = 0; k < x.size(); ++k)
    CHECK(std::hypot(u.u[k] + stream.real(), u.v[k] + stream.imag()) < 0.02);
}

TEST_CASE("beside the tips of a thin ellipse the flow is the potential flow to first order") {
  const auto worst = [](int panels) {
    const Wall wall(thin(), panels);
    const auto sheet = sheet_of(wall);
    double most = 0;
    for (const double off : {0.3, 1.0, 2.0, 4.0, 10.0})  // in radii of the tip
      for (const double angle : {-1.2, -0.4, 0.1, 0.9}) {
        const double r = b * b / a;
        const Complex z = a - r + (1 + off) * r * std::polar(1.0, angle);
        vortex::Velocities u(1);
        const std::vector<double> x{z.real()}, y{z.imag()};
        wall.add_velocity(sheet, {.cores = fmm::Cores::source, .method = fmm::SumMethod::direct},
                          {x, y}, u);
        const Complex exact = past_ellipse(z), found = Complex{u.u[0], -u.v[0]} + std::conj(stream);
        most = std::max(most, std::abs(found - exact) / std::abs(exact));
      }
    return most;
  };
  const double coarse = worst(400), fine = worst(1600);  // panels at tips half as long
  CAPTURE(coarse, fine);
  CHECK(coarse < 0.15);
  CHECK(fine < 0.6 * coarse);
}

TEST_CASE("a core beside a thin body is felt as three points are, on its other side, too") {
  const Wall wall(thin(), 400);
  for (const double x : {0.0, 0.3, 0.45, 0.49, 0.4995})
    for (const double sigma : {0.004, 0.01, 0.03}) {
      const double y = b * std::sqrt(1 - x * x / (a * a)) + sigma / 4;
      vortex::Blobs blobs;
      blobs.append({x, y}, 1, sigma);
      const FoldedBlobs core = fold(blobs, &wall.shape());
      const vortex::ThreePoints three(core.deviator(0), wall.shape().nearest(core.at(0)));
      const Complex arm = std::sqrt(Complex{three.arm_squared.re, three.arm_squared.im});
      const Complex at = test::complex(core.at(0));
      const FoldedBlobs points{{at.real(), (at + arm).real(), (at - arm).real()},
                               {at.imag(), (at + arm).imag(), (at - arm).imag()},
                               {0.01, 0.01, 0.01}};
      const std::vector<double> one{1.0}, shares{1 - three.outer, three.outer / 2, three.outer / 2};
      const auto slip = wall.slip({}, test::sampled(wall, core, one), core, one),
                 exact = wall.slip({}, test::sampled(wall, points, shares), points, shares);
      double off = 0, most = 0;
      for (std::size_t i = 0; i < wall.panels(); ++i) {
        off = std::max(off, std::abs(slip[i] - exact[i]));
        most = std::max(most, std::abs(exact[i]));
      }
      CAPTURE(x, sigma, off, most);
      CHECK(off < 0.01 * most);  // two Gauss points for either, and the series
    }
}

TEST_CASE("the impulse of a sheet on graded panels is that of the added mass, by either route") {
  const Wall wall(thin(), 400);
  const auto sheet = sheet_of(wall);
  // -sum gamma b y and sum gamma b x are the impulse of fluid and body, per unit density.
  const double pi = std::numbers::pi, area = pi * a * b;
  const Vec2 first = wall.first_moment(sheet);
  CHECK(-first.y == Approx((pi * b * b + area) * stream.real()).epsilon(1e-3));
  CHECK(first.x == Approx((pi * a * a + area) * stream.imag()).epsilon(1e-3));
  const vortex::Load load = vortex::pressure_loads(sheet, wall, 0.5)[0];
  CHECK(load.force.x == Approx(-first.y / 0.5).epsilon(1e-12));
  CHECK(load.force.y == Approx(first.x / 0.5).epsilon(1e-12));
  CHECK(wall.area() == Approx(area).epsilon(1e-5));
}
