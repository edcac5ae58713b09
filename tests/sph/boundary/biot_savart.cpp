#include "sph/boundary/biot_savart.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "body/shapes/circle.hpp"
#include "tree/clouds.hpp"

using namespace vortree;
using namespace vortree::sph;

namespace {

struct Vortex {
  Vec2 at;
  double gamma;
};

/// Particles anywhere in a square of side 1 about the middle, with any vorticity.
struct Whirls {
  Cloud cloud;
  std::vector<Slopes> slopes;
  std::vector<Vortex> vortices;

  void add(Vec2 at, double s, ParticleKind kind, double omega) {
    cloud.add(at, s, kind);
    Slopes of{};
    of[1].x = 0.25 * omega, of[0].y = -0.75 * omega;
    slopes.push_back(of);
    const double share = kind == ParticleKind::wall ? 0.5 : 1;
    if (kind < ParticleKind::outer) vortices.push_back({at, share * s * s * omega});
  }

  explicit Whirls(int n) {
    vortree::test::Chance chance(3);
    const ParticleKind kinds[] = {ParticleKind::fluid, ParticleKind::ring, ParticleKind::wall,
                                  ParticleKind::outer, ParticleKind::outlet};
    for (int k = 0; k < n; ++k) {
      const Vec2 at{chance.real() - 0.5, chance.real() - 0.5};
      add(at, 0.02 + 0.05 * chance.real(), kinds[k % 5], 4 * chance.real() - 1);
    }
  }
};

Vec2 direct(const std::vector<Vortex>& vortices, Vec2 at, Vec2 stream) {
  Vec2 sum = stream;
  for (const auto& [from, gamma] : vortices) {
    const Vec2 d = at - from;
    sum += gamma / (2 * std::numbers::pi * dot(d, d)) * Vec2{-d.y, d.x};
  }
  return sum;
}

const OuterBox wide{{-5, -4}, {6, 4}};

/// Nodes on the box, and what is there.
struct Seen {
  std::vector<double> x, y, u, v;
  Seen(const BiotSavart& far, Vec2 stream) {
    for (const BoundaryNode& node : box_nodes(wide, 0.7))
      x.push_back(node.at.x), y.push_back(node.at.y);
    u.resize(x.size(), 1e9), v.resize(x.size(), 1e9);
    far.velocity(x, y, stream, u, v);
  }
};

void check_direct(const Seen& seen, const std::vector<Vortex>& vortices, Vec2 stream) {
  double error = 0, size = 0;
  for (std::size_t k = 0; k < seen.x.size(); ++k) {
    const Vec2 exact = direct(vortices, {seen.x[k], seen.y[k]}, stream),
               d = Vec2{seen.u[k], seen.v[k]} - exact, induced = exact - stream;
    error += dot(d, d), size += dot(induced, induced);
  }
  CHECK(error <= 1e-12 * size);  // sums err by 1e-6
}

}  // namespace

TEST_CASE("the far field's velocity is the sum over the particles' vorticity and the stream") {
  const Whirls whirls(500);
  const Vec2 stream{0.8, 0.3};
  BiotSavart far(wide, 1, {}, 1e-7);
  far.renew(whirls.cloud, whirls.slopes, stream, stream);
  check_direct(Seen(far, stream), whirls.vortices, stream);
  double circulation = 0;
  Vec2 impulse{};
  for (const auto& [at, gamma] : whirls.vortices)
    circulation += gamma, impulse += gamma * Vec2{at.y, -at.x};
  CHECK(far.circulation() == Approx(circulation).epsilon(1e-13));
  CHECK(far.impulse().x == Approx(impulse.x).epsilon(1e-13));
  CHECK(far.impulse().y == Approx(impulse.y).epsilon(1e-13));
}

TEST_CASE("without vorticity the far field is the stream") {
  const BiotSavart far(wide, 1, {}, 1e-7);
  const Seen seen(far, {0.5, -2});
  CHECK(std::ranges::all_of(seen.u, [](double u) { return u == 0.5; }));
  CHECK(std::ranges::all_of(seen.v, [](double v) { return v == -2; }));
  CHECK(far.circulation() == 0);
}

namespace {

/// Nodes of an outlet on the right of `wide`, passed at 0.8 by vorticity sin(y).
struct Outlet {
  Cloud cloud;
  std::vector<Slopes> slopes;
  double flux_up = 0, moment = 0;  // of half of the nodes; of all, times y

  Outlet() {
    std::int32_t place = 0;
    for (const BoundaryNode& node : box_nodes(wide, 0.1)) {
      if (node.normal.x > -0.5) continue;
      const std::size_t i = cloud.add(node, ParticleKind::outlet, place++);
      cloud.u[i] = 0.8;
      Slopes of{};
      of[1].x = std::sin(node.at.y);
      slopes.push_back(of);
      if (std::abs(node.at.y) > 3.5) continue;  // the margin
      if (node.at.y > 0) flux_up += 0.8 * of[1].x * node.spacing;
      moment += 0.8 * of[1].x * node.spacing * node.at.y;
    }
  }
};

double sum_times(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
  return sum;
}

}  // namespace

TEST_CASE("what flows out of the outlet becomes vortices of the same circulation and moment") {
  const Outlet outlet;
  const Vec2 stream{1, 0};
  BiotSavart far(wide, 0.5, {}, 1e-7);
  for (int step = 0; step < 100; ++step)
    far.carry_out(outlet.cloud, outlet.slopes, stream, 0.01 * stream, 0.01);
  // In each release of a way of 0.06, but for what still waits.
  const double waits = std::ranges::max(far.leaving, {}, [](double g) { return std::abs(g); });
  CHECK(waits <= 0.8 * 0.1 * 0.06);
  std::vector<double> y;
  for (const BoundaryNode& node : box_nodes(wide, 0.1))
    if (node.normal.x < -0.5) y.push_back(node.at.y);
  const double left = sum_times(far.left_gamma, far.left_y) + sum_times(far.leaving, y);
  CHECK(left == Approx(outlet.moment).epsilon(1e-10));
  double up = 0;
  for (std::size_t k = 0; k < far.left_y.size(); ++k)
    if (far.left_y[k] > 0) up += far.left_gamma[k];
  for (std::size_t k = 0; k < y.size(); ++k)
    if (y[k] > 0) up += far.leaving[k];
  CHECK(up == Approx(outlet.flux_up).epsilon(1e-10));
  CHECK(std::ranges::max(far.left_x) < 6 + 1);
  CHECK(std::ranges::min(far.left_x) > 6);
}

TEST_CASE("what leaves a box that moves across the stream stands where its way has led it") {
  const Outlet outlet;
  const double dt = 1.0 / 128;
  BiotSavart far(wide, 0.5, {}, 1e-7);
  // 0.1 a node apart: a way of 0.05 along the stream is behind after 7 steps, the last of each
  // release; across it, the box moves by more.
  for (int step = 0; step < 7; ++step)
    far.carry_out(outlet.cloud, outlet.slopes, {1, 0}, {dt, 2 * dt}, dt);
  REQUIRE(!far.left_x.empty());
  CHECK(far.travelled.x == 0);
  CHECK(far.travelled.y == 0);
  for (const double x : far.left_x) CHECK(x == Approx(6 + 3.5 * dt).epsilon(1e-12));
  // Without the two nodes on the margin, all but the middle one, whose vorticity is 0.
  std::vector<double> expected;
  for (const BoundaryNode& node : box_nodes(wide, 0.1))
    if (node.normal.x < -0.5 && std::abs(node.at.y) < 3.45 && std::abs(node.at.y) > 1e-9)
      expected.push_back(node.at.y + 7 * dt);
  REQUIRE(far.left_y.size() >= expected.size());
  for (const double y : expected)
    CHECK(std::ranges::any_of(far.left_y, [&](double left) { return std::abs(left - y) < 1e-12; }));
}

TEST_CASE("what has left drifts on and counts, whatever the particles are") {
  const Whirls whirls(50);
  const Vec2 stream{2, 0.5};
  BiotSavart far(wide, 0.5, {}, 1e-7);
  far.left_x = {5.9, 5.8}, far.left_y = {0.3, -0.2}, far.left_gamma = {0.7, -0.4};
  far.carry_out({}, {}, stream, stream, 1);
  far.renew(whirls.cloud, whirls.slopes, stream, stream);
  std::vector<Vortex> all = whirls.vortices;
  all.push_back({{7.9, 0.8}, 0.7}), all.push_back({{7.8, 0.3}, -0.4});
  check_direct(Seen(far, stream), all, stream);
  far.renew({}, {}, stream, stream);
  CHECK(far.circulation() == Approx(0.3).epsilon(1e-15));
  CHECK(far.impulse().y == Approx(-0.7 * 7.9 + 0.4 * 7.8).epsilon(1e-14));
}

TEST_CASE("vorticity counts within the margin of the side alone by which the stream leaves") {
  const double margin = 0.5;
  const Vec2 left{-4.8, 0}, right{5.8, 0}, bottom{0, -3.8}, top{0, 3.8}, middle{0, 0};
  struct Case {
    Vec2 stream;
    std::vector<Vec2> count;
  };
  for (const auto& [stream, count] :
       {Case{{1, 0.2}, {middle, right}}, Case{{-1, 0.2}, {middle, left}},
        Case{{0.3, 1}, {middle, top}}, Case{{0.3, -1}, {middle, bottom}}, Case{{0, 0}, {middle}}}) {
    CAPTURE(stream.x, stream.y);
    for (const Vec2 at : {left, right, bottom, top, middle}) {
      Whirls one(0);
      one.add(at, 0.1, ParticleKind::fluid, 2);
      BiotSavart far(wide, margin, {}, 1e-7);
      far.renew(one.cloud, one.slopes, stream, stream);
      const bool counts = std::ranges::any_of(
          count, [&](Vec2 there) { return there.x == at.x && there.y == at.y; });
      CHECK(far.circulation() == Approx(counts ? 0.02 : 0).epsilon(1e-14));
    }
  }
}

TEST_CASE("amid the vorticity particles have cores of 1.5 of their spacings") {
  const Whirls whirls(100);
  const double pi = std::numbers::pi;
  BiotSavart far(wide, 0.5, {}, 1e-7);
  far.renew(whirls.cloud, whirls.slopes, {1, 0}, {1, 0});
  std::vector<double> x, y;
  for (int k = 0; k < 50; ++k) x.push_back(0.02 * k - 0.5), y.push_back(0.3 * std::sin(k));
  std::vector<double> u(50, 1e9), v(50, 1e9);
  far.velocity_among(x, y, u, v);
  double error = 0, size = 0;
  for (int k = 0; k < 50; ++k) {
    Vec2 exact{};
    for (std::size_t i = 0; i < whirls.cloud.size(); ++i) {
      if (whirls.cloud.kind[i] >= ParticleKind::outer) continue;
      const Vec2 d = Vec2{x[k], y[k]} - whirls.cloud.at(i);
      const double share = whirls.cloud.kind[i] == ParticleKind::wall ? 0.5 : 1;
      const double gamma = share * whirls.cloud.volume(i) * vorticity(whirls.slopes[i]);
      const double r2 = dot(d, d), core = 1.5 * whirls.cloud.spacing[i];
      exact += -gamma / (2 * pi) * std::expm1(-r2 / (core * core)) / r2 * Vec2{-d.y, d.x};
    }
    const Vec2 off = Vec2{u[k], v[k]} - exact;
    error += dot(off, off), size += dot(exact, exact);
  }
  CHECK(error <= 1e-12 * size);  // sums err by 1e-6
}

TEST_CASE("a vortex passes the outlet without a jump of what it makes there") {
  // Of the particles it leaves by its flux, of the vortices it stands in the middle of its way: the
  // whole of it counts at all times.
  const Outlet outlet;
  BiotSavart far(wide, 0.5, {}, 1e-7);
  const double dt = 1.0 / 128;
  double before = 0;
  for (int step = 1; step <= 40; ++step) {
    far.carry_out(outlet.cloud, outlet.slopes, {1, 0}, {dt, 0}, dt);
    far.renew(outlet.cloud, outlet.slopes, {1, 0}, {1, 0});
    double up = 0;
    for (std::size_t k = 0; k < far.left_y.size(); ++k) up += far.left_gamma[k] * far.left_y[k];
    for (std::size_t k = 0; k < far.leaving.size(); ++k) up += far.leaving[k] * outlet.cloud.y[k];
    CHECK(up - before == Approx(dt * outlet.moment).epsilon(1e-10));
    CHECK(far.impulse().x == Approx(up).epsilon(1e-10));
    before = up;
  }
}

TEST_CASE("the sheet on a circle that slips as in potential flow is the dipole of the circle") {
  const int n = 64;
  const double radius = 0.5, ds = 2 * std::numbers::pi * radius / n;
  Cloud cloud;
  for (int k = 0; k < n; ++k) {
    const double a = 2 * std::numbers::pi * (k + 0.5) / n;
    const Vec2 e{std::cos(a), std::sin(a)};
    const std::size_t i = cloud.add(BoundaryNode{radius * e, e, ds}, ParticleKind::wall, k);
    cloud.u[i] = 2 * std::sin(a) * std::sin(a), cloud.v[i] = -2 * std::sin(a) * std::cos(a);
  }
  std::vector<Slopes> none(cloud.size());
  // A pair in the wake, whose far field is below 1e-8, so that the sheet is not all.
  for (const double gamma : {1e-5, -1e-5}) {
    cloud.add({5.5, gamma}, 1, ParticleKind::fluid);
    none.push_back({});
    none.back()[1].x = gamma;
  }
  BiotSavart far(wide, 1, {}, 1e-7);
  far.renew(cloud, none, {1, 0}, {1, 0});
  far.add_sheet(cloud);
  // Trapezia are exact for the trigonometric polynomials of the sheet and of its impulse.
  CHECK(far.circulation() == Approx(0).margin(1e-13));
  CHECK(far.impulse().x == Approx(-2 * std::numbers::pi * radius * radius).epsilon(1e-9));
  CHECK(far.impulse().y == Approx(0).margin(1e-13));
  Seen seen(far, {1, 0}), among = seen;
  far.velocity_among(among.x, among.y, among.u, among.v);
  for (std::size_t k = 0; k < seen.x.size(); ++k) {
    CHECK(among.u[k] == Approx(seen.u[k] - 1).margin(1e-6));
    CHECK(among.v[k] == Approx(seen.v[k]).margin(1e-6));
    const double x = seen.x[k], y = seen.y[k], r2 = x * x + y * y, c = radius * radius / (r2 * r2);
    CHECK(seen.u[k] == Approx(1 - c * (x * x - y * y)).margin(1e-7));
    CHECK(seen.v[k] == Approx(-2 * c * x * y).margin(1e-7));
  }
}

TEST_CASE("a body that turns has its circulation, and its wall's own velocity is no slip") {
  const int n = 64;
  const double pi = std::numbers::pi, radius = 0.5, rate = 3;
  Cloud cloud;
  for (int k = 0; k < n; ++k) {
    const double a = 2 * pi * (k + 0.5) / n;
    const Vec2 e{std::cos(a), std::sin(a)};
    cloud.add(BoundaryNode{radius * e, e, 2 * pi * radius / n}, ParticleKind::wall, k);
  }
  const double circulation = 2 * rate * pi * radius * radius;
  const StandingBodies circle({{.shape = body::circle({}, radius),
                                .spin = rate,
                                .area = pi * radius * radius,
                                .nodes = n}});
  BiotSavart far(wide, 1, circle, 1e-7);
  const std::vector<Slopes> none(cloud.size());
  far.renew(cloud, none, {1, 0}, {1, 0});
  CHECK(far.circulation() == Approx(circulation).epsilon(1e-14));
  check_direct(Seen(far, {1, 0}), {{{0, 0}, circulation}}, {1, 0});
  // Fluid at rest around it: the sheet takes back what the body has.
  far.add_sheet(cloud);
  CHECK(far.circulation() == Approx(0).margin(1e-12));
  const Seen still(far, {1, 0});
  for (std::size_t k = 0; k < still.x.size(); ++k) CHECK(still.u[k] == Approx(1).margin(1e-5));
  // Fluid that turns with its wall has no sheet.
  for (std::size_t i = 0; i < cloud.size(); ++i)
    cloud.u[i] = -rate * cloud.y[i], cloud.v[i] = rate * cloud.x[i];
  far.renew(cloud, none, {1, 0}, {1, 0});
  far.add_sheet(cloud);
  CHECK(far.circulation() == Approx(circulation).epsilon(1e-12));
}
