#include "vortex/cores/folded_core.hpp"

#include <catch2/catch.hpp>
#include <numbers>

#include "vortex/transport/spread_cores.hpp"

using namespace vortree::vortex;

namespace {

/// The folded Gaussian across a flat wall, whole over the distance 0 to infinity.
double profile(double distance, double y, double s) {
  const double a = (distance - y) / s, b = (distance + y) / s;
  return folded::inverse_sqrt_pi / s * (std::exp(-a * a) + std::exp(-b * b));
}

/// Simpson's rule over 0 to `end`.
template <class F>
double integral(double end, F f) {
  constexpr int n = 4000;
  const double h = end / n;
  double sum = f(0.0) + f(end);
  for (int k = 1; k < n; ++k) sum += (k % 2 ? 4 : 2) * f(k * h);
  return sum * h / 3;
}

const double distances[] = {0, 1e-6, 0.01, 0.1, 0.3, 0.7, 1, 1.5, 2, 3, 3.9};  // in cores
const double cores[] = {0.3, 0.02, 1e-4};

}  // namespace

TEST_CASE("the profile of a folded core is that of exp and erf, to 5e-16") {
  // Numbers from 1 to 2 are rounded by 1.1e-16 at most: twice in the table, once in the last sum of
  // the series, once in what it is compared with.
  for (int k = -4000; k <= 4000; ++k) {
    const double q = 1e-3 * k + 1e-4 * (k % 7), bell = std::exp(-q * q);
    if (std::abs(q) > folded::support) continue;
    const folded::Profile at = folded::profile(q);
    const double mean = folded::inverse_sqrt_pi * bell + q * std::erf(q);
    CHECK(std::abs(at.mean - mean) <= 5e-16 * std::max(1.0, mean));
    CHECK(std::abs(at.erf - std::erf(q)) <= 5e-16);
    CHECK(std::abs(at.slope - 2 * folded::inverse_sqrt_pi * bell) <= 5e-16);
  }
}

TEST_CASE("a core however thin, or of no finite place, has a profile, and that of one far away") {
  for (const double q : {4.01, 5.0, 1e3, 4e7, 1e15, 1e300, double(INFINITY)})
    for (const double sign : {1.0, -1.0}) {
      const folded::Profile at = folded::profile(sign * q);
      CHECK(at.mean == q);
      CHECK(at.erf == sign);
      CHECK(at.slope == 0);
    }
  CHECK(std::isnan(folded::profile(NAN).mean));
  CHECK(folded::mean_distance(-1, 1e-30, 0) == 1);
  CHECK(std::isfinite(folded::place(1, 1e-30, 0).y));
}

TEST_CASE("mean and variance of a folded core at a flat wall are the quadrature's to 1e-10") {
  for (double s : cores) {
    for (double q : distances) {
      const double y = q * s, end = y + 7 * s;
      const double whole = integral(end, [&](double t) { return profile(t, y, s); });
      const double mean = integral(end, [&](double t) { return t * profile(t, y, s); });
      const double square = integral(end, [&](double t) { return t * t * profile(t, y, s); });
      const double m = folded::mean_distance(y, s, 0);
      CHECK(std::abs(whole - 1) < 1e-10);
      CHECK(std::abs(m - mean) < 1e-10 * s);
      CHECK(std::abs(folded::moments(y, s, 0).across - (square - mean * mean)) < 1e-10 * s * s);
    }
  }
}

TEST_CASE("a core far from the wall is free: its mean is its centre, its variance sigma^2/2") {
  CHECK(folded::mean_distance(0.41, 0.1, 2.0) == 0.41);
  CHECK(folded::moments(0.41, 0.1, 2.0).across == Approx(0.1 * 0.1 / 2).epsilon(1e-15));
  const folded::Gaussian free = folded::place(0.41, 0.1, 2.0);
  CHECK(free.y == 0.41);
  CHECK(free.s == 0.1);
}

TEST_CASE("the seam between folded and free is no wider than 1e-8 cores") {
  for (double kappa : {0.0, 2.0}) {
    const double s = 0.1, inside = folded::support * s * (1 - 1e-14);
    CHECK(std::abs(folded::mean_distance(inside, s, kappa) - inside) < 1e-8 * s);
  }
}

TEST_CASE("placing a core by its mean distance inverts the mean to 1e-12 cores") {
  for (double s : cores) {
    for (double kappa : {0.0, 2.0}) {
      for (double q : {0.01, 0.1, 0.3, 0.7, 1.0, 1.5, 2.0, 3.0, 3.9}) {
        const double m = folded::mean_distance(q * s, s, kappa);
        const folded::Gaussian core = folded::place(m, s, kappa);
        INFO("y/s = " << q << ", s = " << s << ", kappa = " << kappa);
        CHECK(core.s == s);
        CHECK(std::abs(folded::mean_distance(core.y, core.s, kappa) - m) < 1e-12 * s);
      }
    }
  }
}

TEST_CASE("a core all but on the wall, where mean and centre are least bound, is placed to 1e-8") {
  for (double s : {0.02, 1e-4}) {
    for (double kappa : {0.0, 2.0, -2.0}) {
      for (double q : {0.0, 1e-6, 1e-4}) {
        const double m = folded::mean_distance(q * s, s, kappa);
        const folded::Gaussian core = folded::place(m, s, kappa);
        INFO("y/s = " << q << ", s = " << s << ", kappa = " << kappa);
        CHECK(core.s <= s * (1 + 1e-8));
        CHECK(core.y >= 0);
        CHECK(std::abs(folded::mean_distance(core.y, core.s, kappa) - m) < 1e-8 * s);
      }
    }
  }
}

TEST_CASE("a mean nearer than sigma/sqrt(pi) squeezes the core onto the wall") {
  for (double s : cores) {
    for (double part : {0.99, 0.7, 0.3, 0.21}) {
      const double m = part * s * folded::inverse_sqrt_pi;
      const folded::Gaussian core = folded::place(m, s, 0);
      CHECK(core.y == 0);
      CHECK(core.s == Approx(part * s).epsilon(1e-14));
      CHECK(folded::mean_distance(core.y, core.s, 0) == Approx(m).epsilon(1e-14));
    }
  }
}

TEST_CASE("no core is squeezed below the thinnest, not even by a mean within the body") {
  for (double m : {0.1, 0.0, -0.3, -5.0}) {
    const folded::Gaussian core = folded::place(m * 0.02 * folded::inverse_sqrt_pi, 0.02, 0);
    CHECK(core.y == 0);
    CHECK(core.s == Approx(folded::thinnest * 0.02).epsilon(1e-14));
  }
}

TEST_CASE("spreading a folded core is the heat flow that no flux leaves through a flat wall") {
  const double s = 0.02, nu = 1e-3, dt = 0.03, width = std::sqrt(4 * nu * dt);
  Blobs blobs;
  blobs.append({0, 0}, 1, s);
  spread_cores(blobs, nu, dt);
  for (double y : {0.0, 0.01, 0.05}) {
    for (double t : {0.0, 0.004, 0.02, 0.07}) {
      const double heat = integral(
          y + 7 * s, [&](double from) { return profile(from, y, s) * profile(t, from, width); });
      CHECK(std::abs(heat - profile(t, y, blobs.sigma[0])) < 1e-10 * profile(y, y, s));
    }
  }
}
