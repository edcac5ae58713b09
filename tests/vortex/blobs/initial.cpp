#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "exact/kirchhoff_ellipse.hpp"
#include "exact/vortex_pairs.hpp"
#include "vortex/blobs/energy.hpp"
#include "vortex/blobs/lattice.hpp"
#include "vortex/blobs/moments.hpp"
#include "vortex/flows.hpp"
#include "vortex/step.hpp"
#include "vortex/wall/vorticity.hpp"

using namespace vortree;
using vortex::Blobs;
using vortex::Lattice;

namespace {

constexpr double pi = std::numbers::pi;

/// The largest error of the blobs' vorticity, relative to the peak, at points out to two widths.
template <class Omega>
double largest_error(const Blobs& blobs, Vec2 centre, double a, double b, Omega exact) {
  std::vector<double> x, y;
  for (int j = -12; j <= 12; ++j)
    for (int i = -12; i <= 12; ++i) {
      x.push_back(centre.x + i * a / 6.1);
      y.push_back(centre.y + j * b / 6.3);
    }
  std::vector<double> omega(x.size());
  vorticity(blobs, nullptr, {x, y}, omega);
  double worst = 0;
  for (std::size_t k = 0; k < x.size(); ++k)
    worst = std::max(worst, std::abs(omega[k] - exact(x[k] - centre.x, y[k] - centre.y)));
  return worst / exact(0, 0);
}

vortex::Problem inviscid(const fmm::Options& velocity, double dt) {
  return {.flow = {{}, 0},
          .dt = dt,
          .scheme = flow::Scheme::rk4,
          .advecting_cores = std::numbers::sqrt2,
          .sigma_0 = 1,
          .splitting = {1},
          .merging = {.tolerance = 0, .sigma_max = 1},
          .sums = velocity};
}

double tilt(const vortex::Moments& moments) {
  return 0.5 * std::atan2(moments.quadrupole.y, moments.quadrupole.x);
}

}  // namespace

TEST_CASE("elliptical and perturbed Gaussians cut into blobs are themselves again, to 3e-4") {
  const Lattice lattice{{0.3, -0.1}, 0.03, 0.03};
  const Blobs ellipse = vortex::gaussian_ellipse(lattice, 2, 0.28, 0.14);
  CHECK(largest_error(ellipse, lattice.centre, 0.28, 0.14, [](double x, double y) {
          return 2 / (pi * 0.28 * 0.14) * std::exp(-x * x / (0.28 * 0.28) - y * y / (0.14 * 0.14));
        }) < 3e-4);
  const Blobs tripole = vortex::perturbed_vortex(lattice, 2, 0.2, 0.9);
  CHECK(largest_error(tripole, lattice.centre, 0.2, 0.2, [](double x, double y) {
          const double a2 = 0.04;
          return 2 / (pi * a2) * std::exp(-(x * x + y * y) / a2) * (1 + 0.9 * (x * x - y * y) / a2);
        }) < 3e-4);
  CHECK_THROWS_AS(vortex::gaussian_ellipse(lattice, 1, 0.2, 0.03), std::invalid_argument);
  CHECK_THROWS_AS(vortex::uniform_ellipse({{}, 0.1, 0}, 1, 1, 1), std::invalid_argument);
}

TEST_CASE("the moments of known shapes: circulation, quadrupole, tilt, separation") {
  // int omega (x^2 - y^2) of a Gaussian ellipse is gamma (a^2 - b^2)/2, of a uniform one a quarter.
  const Lattice lattice{{0.3, -0.1}, 0.03, 0.03};
  const vortex::Moments gaussian = moments(vortex::gaussian_ellipse(lattice, 2, 0.28, 0.14));
  CHECK(gaussian.quadrupole.x == Approx(0.28 * 0.28 - 0.14 * 0.14).epsilon(1e-7));
  CHECK(gaussian.quadrupole.y == Approx(0).margin(1e-12));
  CHECK(gaussian.separation == Approx(2 * 0.28 / std::sqrt(pi)).epsilon(1e-4));
  const vortex::Moments uniform = moments(vortex::uniform_ellipse(lattice, 2, 1, 0.5));
  CHECK(uniform.quadrupole.x == Approx(0.5 * (1 - 0.25)).epsilon(1e-3));

  Blobs pair;
  pair.append({1, 1}, 0.5, 0.1);
  pair.append({2, 1 + std::sqrt(3.0)}, 0.5, 0.1);
  CHECK(tilt(moments(pair)) == Approx(pi / 3));
  CHECK(moments(pair).separation == Approx(2));
  CHECK(moments(pair).positive == 1);
  pair.gamma[1] = -0.5;
  CHECK(moments(pair).separation == Approx(2));
  CHECK(moments(pair).positive_centre.y == 1);
}

TEST_CASE("energy of a Gaussian vortex: enstrophy gamma^2/(2 pi a^2), which is what it loses") {
  const double a = 0.2, nu = 1e-3, h = 0.5;
  const vortex::Energy now = energy(vortex::gaussian_vortex({}, 1, a, 0.04, 0.04));
  CHECK(now.enstrophy == Approx(1 / (2 * pi * a * a)).epsilon(1e-6));
  // psi of two Gaussians of width a: s^2 = 2 a^2.
  CHECK(now.energy ==
        Approx(-(std::log(2 * a * a) - std::numbers::egamma) / (8 * pi)).epsilon(1e-6));
  const auto spread = [&](double t) {
    return energy(vortex::gaussian_vortex({}, 1, std::sqrt(a * a + 4 * nu * t), 0.04, 0.04));
  };
  CHECK((spread(h).energy - spread(-h).energy) / (2 * h) ==
        Approx(-nu * now.enstrophy).epsilon(1e-3));
}

TEST_CASE("Kirchhoff's ellipse turns at a b/(a + b)^2 of its vorticity; the error falls with h") {
  const exact::KirchhoffEllipse ellipse{pi / 2, 1, 0.5};
  CHECK(ellipse.vorticity() == Approx(1));
  CHECK(ellipse.rate() == Approx(2.0 / 9));
  const auto direct = fmm::Options{.cores = fmm::Cores::mean, .method = fmm::SumMethod::direct};
  const auto error = [&](double h) {
    Blobs blobs = vortex::uniform_ellipse({{}, 1.25 * h, h}, pi / 2, 1, 0.5);
    const double before = energy(blobs).energy;
    for (int k = 0; k < 20; ++k) step(blobs, inviscid(direct, 0.2), k, [](std::string_view) {});
    CHECK(energy(blobs).energy == Approx(before).epsilon(1e-7));
    return std::abs(tilt(moments(blobs)) / (4 * ellipse.rate()) - 1);
  };
  const double coarse = error(0.1), fine = error(0.05);
  CHECK(coarse < 0.015);
  CHECK(fine < 0.6 * coarse);
}

TEST_CASE("a pair of blobs that act by both cores travels, or circles, as Gaussians do") {
  const auto direct = fmm::Options{.cores = fmm::Cores::mean, .method = fmm::SumMethod::direct};
  const exact::VortexPair pair{1, 0.6, 1, 0};
  CHECK(pair.travelled(3) == Approx(3 * pair.speed(0)));
  const exact::VortexPair viscous{1, 0.6, 1, 0.01};
  CHECK((viscous.travelled(2.01) - viscous.travelled(1.99)) / 0.02 == Approx(viscous.speed(2)));
  for (double right : {-1.0, 1.0}) {
    Blobs blobs;
    blobs.append({-0.5, 0}, 1, 0.6);
    blobs.append({0.5, 0}, right, 0.6);
    for (int k = 0; k < 10; ++k) step(blobs, inviscid(direct, 0.05), k, [](std::string_view) {});
    if (right < 0)
      CHECK(blobs.y[0] == Approx(pair.travelled(0.5)).epsilon(1e-9));
    else
      CHECK(tilt(moments(blobs)) == Approx(2 * pair.travelled(0.5)).epsilon(1e-6));
  }
}
