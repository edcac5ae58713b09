#include "vortex/wall/three_points.hpp"

#include <catch2/catch.hpp>
#include <complex>

#include "body/shapes/circle.hpp"
#include "vortex/adapt/split_wide.hpp"
#include "vortex/cores/folded_core.hpp"
#include "vortex/cylinder_flow.hpp"
#include "vortex/strained_flows.hpp"
#include "vortex/wall/tuning.hpp"

using namespace vortree;
using test::Complex;
using vortex::Blobs;
using vortex::Deviator;
using vortex::FoldedBlobs;
using vortex::ThreePoints;
using vortex::Wall;

namespace {

constexpr double pi = std::numbers::pi, radius = 1;

Complex arm_of(const ThreePoints& points) {
  return std::sqrt(Complex{points.arm_squared.re, points.arm_squared.im});
}

std::vector<double> slip_of(const Wall& wall, const FoldedBlobs& at,
                            const std::vector<double>& gamma) {
  return wall.slip({}, test::sampled(wall, at, gamma), at, gamma);
}

/// As bare points at the folded centroids.
FoldedBlobs bare(FoldedBlobs at) {
  at.xx.clear();
  at.xy.clear();
  return at;
}

/// Average slip along each panel by the angles under which it is seen from each of three points.
std::vector<double> slip_by_angles(const Wall& wall, const FoldedBlobs& at,
                                   const std::vector<double>& gamma) {
  const double b = wall.panel_length(0);
  std::vector<double> slip(wall.panels());
  for (std::size_t j = 0; j < gamma.size(); ++j) {
    const ThreePoints points(at.deviator(j), wall.shape().nearest(at.at(j)));
    const Complex z0 = test::complex(at.at(j)), arm = arm_of(points);
    for (std::size_t i = 0; i < slip.size(); ++i) {
      const Complex begin = test::complex(wall.shape().point(i * b)),
                    end = test::complex(wall.shape().point((i + 1) * b));
      const auto seen = [&](Complex z) { return std::arg((end - z) / (begin - z)); };
      slip[i] +=
          gamma[j] / (2 * pi * b) *
          ((1 - points.outer) * seen(z0) + points.outer / 2 * (seen(z0 + arm) + seen(z0 - arm)));
    }
  }
  return slip;
}

/// The wall's slip, but that of the cores' means without what two samples a panel miss far away.
std::vector<double> slip_unsampled(const Wall& wall, const FoldedBlobs& at,
                                   const std::vector<double>& gamma) {
  std::vector<double> slip = slip_of(wall, at, gamma);
  const auto found = slip_of(wall, bare(at), gamma), exact = slip_by_angles(wall, bare(at), gamma);
  for (std::size_t i = 0; i < slip.size(); ++i) slip[i] += exact[i] - found[i];
  return slip;
}

double rms(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

/// Strained blobs beside the circle, some of them wider than panels, some at no reach of them.
Blobs strained_layer() {
  return test::strained(test::layer(400, radius, 0.15, 0.01, 0.06), 0.9);
}

}  // namespace

TEST_CASE("three points have a core's second moment, and none comes nearer than a fifth of m") {
  test::Uniform uniform(5);
  int cut = 0;
  for (int k = 0; k < 3000; ++k) {
    const double m = 0.1 + uniform(), phi = 2 * pi * uniform();
    const body::WallPoint near{0, m, {std::cos(phi), std::sin(phi)}, 4 * uniform() - 2};
    const Deviator d = test::strain(uniform, 2, uniform());
    const ThreePoints points(d, near);
    REQUIRE((points.outer >= 0.5 && points.outer <= 1));
    const Complex arm = arm_of(points), held = points.outer * arm * arm;
    const double part = std::abs(held) / (2 * d.size());
    CHECK(std::abs(held - part * Complex{2 * d.xx, 2 * d.xy}) < 1e-14 * std::abs(held));
    cut += part < 1 - 1e-14;
    if (part < 1 - 1e-14) CHECK(points.outer == 1);
    CHECK(part < 1 + 1e-14);
    // In the frame of the wall, which is a parabola there; where it bends away it leaves more room.
    const double across = dot(near.normal, test::vec2(arm)),
                 along = dot(near.tangent(), test::vec2(arm));
    const double bend = std::min(near.curvature, 0.0) / 2 * along * along;
    CHECK(m - std::abs(across) + bend > (0.2 - 1e-13) * m);
  }
  CHECK((cut > 300 && cut < 2700));
}

TEST_CASE("a round core is a point to the wall, and so is what lies in the body") {
  CHECK(ThreePoints({}, {0, 1, {0, 1}, 1}).none());
  CHECK(ThreePoints({0.1, 0.2}, {0, 0, {0, 1}, 1}).none());
  CHECK(ThreePoints({0.1, 0.2}, {0, -1, {0, 1}, 1}).none());
}

TEST_CASE("cores that no wall folds have the slip of points, to the last bit") {
  const Wall wall(body::circle({}, radius), 100);
  Blobs blobs = test::strained(test::layer(500, 1.6, 1, 0.01, 0.08), 0.7);
  FoldedBlobs at = fold(blobs, &wall.shape());
  for (std::size_t j = 0; j < blobs.size(); ++j) REQUIRE(at.deviator(j) == Deviator{});
  CHECK(slip_of(wall, at, blobs.gamma) == slip_of(wall, bare(at), blobs.gamma));
  CHECK(fold(blobs, nullptr).xx.empty());
}

TEST_CASE("the slip of cores is that of their three points") {
  // Exact along the panels near a core and for cores farther than three panels; else what moments
  // gathered a panel leave out, six panels and more away.
  for (int panels : {8, 31, 100, 300}) {
    const Wall wall(body::circle({}, radius), panels);
    const Blobs blobs = strained_layer();
    const FoldedBlobs at = fold(blobs, &wall.shape());
    const auto exact = slip_by_angles(wall, at, blobs.gamma);
    const auto points = slip_by_angles(wall, bare(at), blobs.gamma);
    const double error = rms(slip_unsampled(wall, at, blobs.gamma), exact);
    INFO(panels << " panels: " << error / rms(points, exact));
    CHECK(error < 2e-3 * rms(points, exact));
  }
}

TEST_CASE("slip of cores is the same bits for any number of threads") {
  const Wall wall(body::circle({}, radius), 100);
  const Blobs blobs = strained_layer();
  const FoldedBlobs at = fold(blobs, &wall.shape());
  const auto slip = [&] { return slip_of(wall, at, blobs.gamma); };
  const auto once = test::with_threads(1, slip);
  for (int threads : {2, 3}) CHECK(once == test::with_threads(threads, slip));
}

namespace {

/// Mean of (R/r)^n cos n theta over heat that spreads from (R + y, theta = 0) around a circle that
/// lets none through, s^2 = 4 nu t: as a function of where it spreads from this obeys the same
/// equation. Crank and Nicolson in r: a twin that knows nothing of folded cores.
double mean_of_heat(int n, double y, double s) {
  constexpr int cells = 600, steps = 400;
  const double h = 7 * s / cells, dt = s * s / 4 / steps;
  std::vector<double> u(cells), diagonal(cells), right(cells);
  const auto r = [&](double k) { return radius + h * (k + 0.5); };
  const auto harmonic = [&](int k) { return std::pow(radius / r(k), n); };
  for (int k = 0; k < cells; ++k) u[k] = harmonic(k);
  const auto in = [&](int k) { return k > 0 ? r(k - 0.5) / (r(k) * h * h) : 0; };
  const auto out = [&](int k) { return r(k + 0.5) / (r(k) * h * h); };
  const auto rest = [&](int k) { return -in(k)-out(k) - n * n / (r(k) * r(k)); };
  const auto advance = [&](double step, double implicit) {
    const double explicitly = step * (1 - implicit), left = step * implicit;
    for (int k = 0; k < cells; ++k) {
      const double inner = k > 0 ? u[k - 1] : 0, outer = k + 1 < cells ? u[k + 1] : harmonic(cells);
      right[k] = u[k] + explicitly * (in(k)*inner + rest(k) * u[k] + out(k) * outer);
      if (k + 1 == cells) right[k] += left * out(k) * outer;
      diagonal[k] = 1 - left * rest(k);
    }
    for (int k = 1; k < cells; ++k) {
      const double factor = left * in(k) / diagonal[k - 1];
      diagonal[k] -= factor * left * out(k - 1);
      right[k] += factor * right[k - 1];
    }
    u[cells - 1] = right[cells - 1] / diagonal[cells - 1];
    for (int k = cells - 2; k >= 0; --k) u[k] = (right[k] + left * out(k) * u[k + 1]) / diagonal[k];
  };
  // Four small implicit steps first: the wall is no place of rest for (R/r)^n.
  for (int k = 0; k < 4; ++k) advance(dt / 4, 1);
  for (int k = 1; k < steps; ++k) advance(dt, 0.5);
  const double place = y / h - 0.5;
  if (place < 0) return u[0] - (u[1] - u[0]) / 8 * (1 - 4 * y * y / (h * h));
  const int k = static_cast<int>(place);
  return u[k] + (place - k) * (u[k + 1] - u[k]);
}

/// Mode n of a slip around theta = 0, in units of that of a vortex of circulation 1 on the wall.
double mode(int n, const Wall& wall, const std::vector<double>& slip) {
  const double count = static_cast<double>(wall.panels()), half = n * pi / count;
  double sum = 0;
  for (std::size_t i = 0; i < slip.size(); ++i)
    sum += slip[i] * std::cos(n * test::polar_angle(wall.middle(i)));
  return -2 * pi * radius * 2 * sum / count * half / std::sin(half);
}

}  // namespace

TEST_CASE("beside a circle the slip of a folded core errs by O((s/R)^3), a point's by the square") {
  const Wall wall(body::circle({}, radius), 512);  // other modes alias by exp(-512 m/R) < 1e-6
  for (int n : {1, 2, 4}) {
    for (double q : {0.0, 0.5, 1.0}) {
      double error[2], of_point[2];
      for (int fine : {0, 1}) {
        const double s = fine ? 0.05 : 0.1;
        Blobs blobs;
        blobs.append({radius + q * s, 0}, 1, s);
        const FoldedBlobs at = fold(blobs, &wall.shape());
        const double exact = mean_of_heat(n, q * s, s);
        error[fine] = mode(n, wall, slip_unsampled(wall, at, blobs.gamma)) - exact;
        of_point[fine] = mode(n, wall, slip_unsampled(wall, bare(at), blobs.gamma)) - exact;
      }
      INFO("n " << n << ", q " << q << ": " << error[0] << ", " << error[1] << "; " << of_point[0]
                << ", " << of_point[1]);
      // Orders at s = 0.1 and 0.05, less by what the next ones add, up to n s/R = 0.4.
      CHECK(std::log2(error[0] / error[1]) == Approx(2.8).margin(0.25));
      CHECK(std::log2(of_point[0] / of_point[1]) == Approx(1.85).margin(0.2));
      CHECK(error[1] < of_point[1] / 7);
      // The share of mode n that a point has too much, n (n + 1)/2 (m^2 - y^2)/R^2.
      const double s = 0.05, y = q * s, m = vortex::folded::mean_distance(y, s, 1 / radius);
      const double share = n * (n + 1) / 2 * (m * m - y * y) / (radius * radius);
      CHECK(of_point[1] == Approx(share).epsilon(0.25));
    }
  }
}

namespace {

/// A core as 196 points: Gauss's for a Gaussian, fourteen each way; what would lie in the body is
/// reflected.
FoldedBlobs as_many_points(const Blobs& blobs, const body::Shape& wall,
                           std::vector<double>& gamma) {
  static const double node[7] = {0.29174551067256, 0.87871378732940, 1.47668273114114,
                                 2.09518325850772, 2.74847072498540, 3.46265693360227,
                                 4.30444857047363};
  static const double weight[7] = {5.3640590971209e-1, 2.7310560906425e-1, 6.8505534223466e-2,
                                   7.8500547264579e-3, 3.5509261355194e-4, 4.7164843550189e-6,
                                   8.6285911681258e-9};
  const vortex::Core core = blobs.core(0);
  const double direction = 0.5 * std::atan2(core.deviator.xy, core.deviator.xx);
  const Vec2 major{std::cos(direction), std::sin(direction)}, minor{-major.y, major.x};
  const double a = vortex::widest(core), b = std::sqrt(core.square - 2 * core.deviator.size());
  FoldedBlobs at;
  gamma.clear();
  for (int i = 0; i < 14; ++i) {
    for (int j = 0; j < 14; ++j) {
      const auto signed_node = [&](int k) { return k < 7 ? -node[k] : node[k - 7]; };
      Vec2 place = blobs.centre(0) + a * signed_node(i) * major + b * signed_node(j) * minor;
      if (const body::WallPoint w = wall.nearest(place); w.distance < 0)
        place = place - (2 * w.distance) * w.normal;
      at.x.push_back(place.x);
      at.y.push_back(place.y);
      gamma.push_back(weight[i % 7] * weight[j % 7] / pi);
    }
  }
  return at;
}

}  // namespace

TEST_CASE("an elongated core at 2 s has the slip of 196 points, eight times as near as a point") {
  const Wall wall(body::circle({}, radius), 300);
  const double s = wall.panel_length(0) / 1.2;
  for (double phi : {0.0, 0.5, 1.0, 1.5, 2.0, 2.5}) {  // to the normal
    Blobs blobs;
    blobs.append({radius + 2 * s, 0}, 1,
                 vortex::Core{s * s, 0.2 * s * s * Deviator{std::cos(2 * phi), std::sin(2 * phi)}});
    const FoldedBlobs at = fold(blobs, &wall.shape());
    std::vector<double> many;
    const auto points = as_many_points(blobs, wall.shape(), many);
    const auto exact = slip_of(wall, points, many);
    const double error = rms(slip_of(wall, at, blobs.gamma), exact),
                 of_point = rms(slip_of(wall, bare(at), blobs.gamma), exact);
    INFO("direction " << phi << ": " << error << " of a core, " << of_point << " of a point");
    CHECK(error < of_point / 8);
  }
}

TEST_CASE("splitting cores at the wall moves the sheet's moment by a tenth of what it did") {
  const Wall wall(body::circle({}, radius), 300);
  // Wider cores differ by what the split itself errs by at a bent wall, of the next order in s/R:
  // a fifth of what it did for s = 0.12 R.
  for (double s : {0.02, 0.03, 0.06}) {
    Blobs blobs;
    for (int k = 0; k < 300; ++k) {
      const double theta = 2 * pi * k / 300, r = radius + 0.2 * s;
      blobs.append({r * std::cos(theta), r * std::sin(theta)}, std::sin(theta) * 2 * pi / 300, s);
    }
    const auto moment = [&](bool as_points) {
      const FoldedBlobs at = fold(blobs, &wall.shape());
      const auto slip = slip_of(wall, as_points ? bare(at) : at, blobs.gamma);
      return wall.first_moment(wall.sheet(slip, 0)).y;
    };
    const double before = moment(false), of_points = moment(true);
    split_wide(blobs, {.sigma_max = 0.99 * s}, &wall.shape(), 1);
    REQUIRE(blobs.size() == 1200);
    INFO("s " << s << ": " << moment(false) - before << ", as points " << moment(true) - of_points);
    CHECK(std::abs(moment(false) - before) < 0.1 * std::abs(moment(true) - of_points));
  }
}
