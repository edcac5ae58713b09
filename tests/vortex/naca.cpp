#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <numbers>

#include "body/outlines/outline.hpp"
#include "body/shapes/naca0012.hpp"
#include "cylinder_flow.hpp"
#include "flows.hpp"
#include "vortex/wall/forces.hpp"
#include "vortex/wall/wall.hpp"

using namespace vortree;
using vortex::Wall;

namespace {

constexpr double pi = std::numbers::pi, chord = 2, edge = 0.003;

double length(Vec2 a) {
  return std::hypot(a.x, a.y);
}

/// The sheet of a stream of speed 1 at an incidence.
std::vector<double> sheet_of(const Wall& wall, double incidence, double total = 0) {
  const Vec2 stream{std::cos(incidence), std::sin(incidence)};
  return wall.sheet(wall.slip(stream, vortex::Velocities(2 * wall.panels()), {}, {}), total);
}

/// A section of Joukowski whose edge is rounded, since its circle goes around the singular point
/// z = 1 a little further out: z = w + 1/w, w = -offset + R exp(i t), R = 1 + offset + gap.
struct Joukowski {
  double offset = 0.1, gap = 0.1;
  double radius() const { return 1 + offset + gap; }

  body::CurvePoint operator()(double t) const {
    using test::i_unit;
    const test::Complex spoke = std::polar(radius(), t), w = -offset + spoke;
    const test::Complex d1 = i_unit * spoke, d2 = -spoke;
    return {test::vec2(w + 1.0 / w), test::vec2(d1 * (1.0 - 1.0 / (w * w))),
            test::vec2(d2 * (1.0 - 1.0 / (w * w)) + 2.0 * d1 * d1 / (w * w * w))};
  }

  /// Anticlockwise speed along the wall in a stream of speed 1, without circulation.
  double along(double t, double incidence) const {
    const test::Complex w = -offset + std::polar(radius(), t);
    return -2 * std::sin(t - incidence) / std::abs(1.0 - 1.0 / (w * w));
  }
};

/// The parameter of a place on the section.
double parameter(const Joukowski& section, Vec2 place) {
  double t = 0, least = INFINITY;
  for (int k = 0; k < 2000; ++k)
    if (const double off = length(section(2 * pi * k / 2000).at - place); off < least) {
      least = off;
      t = 2 * pi * k / 2000;
    }
  for (int k = 0; k < 20; ++k) {
    const auto c = section(t);
    t += dot(place - c.at, c.first) / dot(c.first, c.first);
  }
  return t;
}

/// The largest error of a section's sheet of potential flow.
double joukowski_error(int panels, double incidence) {
  const Joukowski section;
  const Wall wall(body::outline(section), panels);
  const auto sheet = sheet_of(wall, incidence);
  double largest = 0;
  for (std::size_t i = 0; i < wall.panels(); ++i) {
    const double t = parameter(section, wall.middle(i));
    largest = std::max(largest, std::abs(sheet[i] - section.along(t, incidence)));
  }
  return largest;
}

}  // namespace

TEST_CASE("NACA 0012: thickest by 12 % at 0.3 of the chord, closed at both ends") {
  const auto shape = body::naca0012({}, chord, edge, 0);
  const double length_of_wall = shape->perimeter();
  double thickest = 0, where = 0, front = 0, rear = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vec2 p = shape->point(length_of_wall * i / 4000);
    front = std::min(front, p.x);
    rear = std::max(rear, p.x);
    if (p.y > thickest) {
      thickest = p.y;
      where = p.x;
    }
  }
  CHECK(2 * thickest / chord == Approx(0.12).epsilon(2e-3));
  CHECK(where / chord + 0.5 == Approx(0.3).margin(0.005));
  CHECK(rear == Approx(chord / 2).epsilon(1e-5));
  CHECK(front == Approx(-chord / 2).epsilon(1e-5));
  const auto tip = shape->nearest({chord, 0}), nose = shape->nearest({-chord, 0});
  CHECK(tip.distance == Approx(chord / 2).epsilon(1e-13));
  CHECK(tip.curvature == Approx(1 / (edge * chord)).epsilon(1e-10));
  CHECK(nose.distance == Approx(chord / 2).epsilon(1e-13));
  // Radius of the nose: 1.1019 t^2 chords, t = 0.12, a little less for the rounding of the other.
  CHECK(1 / nose.curvature == Approx(1.1019 * 0.12 * 0.12 * chord).epsilon(2 * edge));
}

TEST_CASE("NACA 0012 as published is that of the trailing edge it has, but for its rounding") {
  const double published = 0.00126;
  const auto shape = body::naca0012({0.5, 0}, 1, published, 0);
  for (double x : {0.05, 0.2, 0.5, 0.8, 0.95}) {
    const double y = 0.6 * (0.2969 * std::sqrt(x) - 0.1260 * x - 0.3516 * x * x +
                            0.2843 * x * x * x - 0.1015 * x * x * x * x);
    const double rounded = y * std::sqrt((1 - x) / (1 - x + published / 2));
    for (double side : {1.0, -1.0})
      CHECK(std::abs(shape->nearest({x, side * rounded}).distance) < 1e-12);
  }
}

TEST_CASE("NACA 0012 turned nose up: its chord points down the stream by the incidence") {
  const double incidence = 0.3;
  const Vec2 centre{0.2, -0.1}, back{std::cos(incidence), -std::sin(incidence)};
  const auto shape = body::naca0012(centre, chord, edge, incidence);
  CHECK(std::abs(shape->nearest(centre + (chord / 2) * back).distance) < 1e-12);
  CHECK(std::abs(shape->nearest(centre - (chord / 2) * back).distance) < 1e-12);
  bench::Uniform uniform(4);
  for (int k = 0; k < 200; ++k) {  // the nearest place is the foot of a normal, and none is nearer
    const Vec2 at{3 * (uniform() - 0.5), 1.5 * (uniform() - 0.5)};
    const auto w = shape->nearest(at);
    const Vec2 foot = at - w.distance * w.normal;
    CHECK(length(foot - shape->point(w.arc)) < 1e-8);
    CHECK(shape->distance(at) == Approx(w.distance).margin(1e-13));
    double least = INFINITY;
    for (int i = 0; i < 3000; ++i)
      least = std::min(least, length(at - shape->point(shape->perimeter() * i / 3000)));
    CHECK(std::abs(w.distance) <= least + 1e-12);
  }
}

TEST_CASE("an edge that is too sharp, too blunt or not a number is turned away") {
  for (double bad : {0.0, -0.01, 5e-5, 0.03, double(NAN)})
    CHECK_THROWS_AS(body::naca0012({}, 1, bad, 0), std::invalid_argument);
  CHECK_THROWS_AS(body::naca0012({}, 0, edge, 0), std::invalid_argument);
}

TEST_CASE("the sheet of a rounded Joukowski section is that of its map, to spectral accuracy") {
  for (double incidence : {0.0, 0.2}) {
    const double coarse = joukowski_error(60, incidence), fine = joukowski_error(90, incidence),
                 finest = joukowski_error(180, incidence);
    CAPTURE(coarse, fine, finest);
    CHECK(fine < 0.2 * coarse);
    CHECK(finest < 0.05 * fine);
    CHECK(finest < 2e-4);
  }
}

TEST_CASE("the sheet of NACA 0012 holds the inside at rest, and no fluid goes through the wall") {
  const double incidence = 0.2;
  const Wall wall(body::naca0012({}, chord, edge, 0), 1000);
  const auto sheet = sheet_of(wall, incidence);
  std::vector<double> x{-0.95, -0.5, 0, 0.5, 0.8, 0.9, 0.95}, y{0, 0.05, -0.02, 0, 0.01, 0, 0};
  const std::size_t inside = x.size();
  for (std::size_t i = 0; i < wall.panels(); i += 7) {
    const auto w = wall.shape().nearest(wall.middle(i));
    const Vec2 out = wall.middle(i) + (0.02 * chord) * w.normal;
    x.push_back(out.x);
    y.push_back(out.y);
  }
  vortex::Velocities u(x.size());
  const auto direct = fmm::Options{.cores = fmm::Cores::source, .method = fmm::SumMethod::direct};
  wall.add_velocity(sheet, direct, {x, y}, u);
  for (std::size_t k = 0; k < inside; ++k)
    CHECK(std::hypot(u.u[k] + std::cos(incidence), u.v[k] + std::sin(incidence)) < 2e-3);
  // Beside the wall the flow goes with it, as fast as the sheet is strong at the wall.
  double flux = 0;
  for (std::size_t k = inside; k < x.size(); ++k) {
    const auto w = wall.shape().nearest({x[k], y[k]});
    flux += dot(Vec2{u.u[k] + std::cos(incidence), u.v[k] + std::sin(incidence)}, w.normal);
  }
  CHECK(std::abs(flux) < 0.5);
}

TEST_CASE("potential flow past NACA 0012 has no drag; its lift is what its circulation makes") {
  // F = int p n ds with p = -gamma^2/2: the sheet is the flow along the wall.
  const double incidence = 0.1;
  for (double total : {0.0, -0.6}) {
    const Wall wall(body::naca0012({}, chord, edge, 0), 1200);
    const auto sheet = sheet_of(wall, incidence, total);
    Vec2 force;
    for (std::size_t i = 0; i < wall.panels(); ++i) {
      const Vec2 t = wall.tangent(i), normal{t.y, -t.x};
      force = force + (0.5 * sheet[i] * sheet[i] * wall.panel_length(i)) * normal;
    }
    const Vec2 lift{std::sin(incidence) * total, -std::cos(incidence) * total};
    CAPTURE(force.x, force.y, total);
    CHECK(length(force - lift) < 5e-3);
  }
}
