#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "body/shapes/circle.hpp"
#include "vortex/adapt/merge_close.hpp"
#include "vortex/adapt/split_wide.hpp"
#include "vortex/cores/folded_core.hpp"
#include "vortex/wall/along_wall.hpp"

using namespace vortree;
using vortex::AdaptedBlobs;
using vortex::Blobs;
using vortex::Covariance;

namespace {

/// Heat that no flux leaves, outside a circle of radius R, as Fourier modes around it; beginning in
/// one point, at a distance y from the circle, till 4 nu t = 1: cells in the radius, and two stages
/// of an L-stable scheme of second order in time.
class Heat {
 public:
  Heat(double R, double y) : R_(R), step_((y + reach) / cells) {
    for (int mode = 0; mode < 3; ++mode) mode_[mode] = flow(mode, y);
  }

  /// Of x - R, where the point lies at (R + y, 0).
  double mean() const { return of(1, 1) / of(0, 0) - R_; }
  double variance() const {
    const double x = of(1, 1) / of(0, 0);
    return (of(0, 2) + of(2, 2)) / (2 * of(0, 0)) - x * x;
  }

 private:
  static constexpr int cells = 1200, steps = 300;
  static constexpr double reach = 6;
  using Column = std::vector<double>;

  double r(int i) const { return R_ + (i + 0.5) * step_; }
  double face(int i) const { return i == 0 || i == cells ? 0 : R_ + i * step_; }
  double of(int mode, int power) const {
    double sum = 0;
    for (int i = 0; i < cells; ++i) sum += mode_[mode][i] * std::pow(r(i), 1 + power) * step_;
    return sum;
  }
  double out(int i) const { return face(i + 1) / (r(i) * step_ * step_); }
  double in(int i) const { return face(i) / (r(i) * step_ * step_); }

  Column laplacian(const Column& u, int mode) const {
    Column result(cells);
    for (int i = 0; i < cells; ++i)
      result[i] = (i + 1 < cells ? out(i) * (u[i + 1] - u[i]) : 0) +
                  (i > 0 ? in(i) * (u[i - 1] - u[i]) : 0) - mode * mode * u[i] / (r(i) * r(i));
    return result;
  }
  /// k of which k - h laplacian(k) is b, by elimination.
  Column implicit(const Column& b, double h, int mode) const {
    Column upper(cells), k(cells);
    for (int i = 0; i < cells; ++i) {
      const double pivot = 1 + h * (out(i) + in(i) + mode * mode / (r(i) * r(i))) +
                           (i > 0 ? h * in(i)*upper[i - 1] : 0);
      upper[i] = -h * out(i) / pivot;
      k[i] = (b[i] + (i > 0 ? h * in(i)*k[i - 1] : 0)) / pivot;
    }
    for (int i = cells - 2; i >= 0; --i) k[i] -= upper[i] * k[i + 1];
    return k;
  }
  Column flow(int mode, double y) const {
    Column u(cells);
    const double place = std::max(y / step_ - 0.5, 0.0);
    const int at = static_cast<int>(place);
    u[at] = (1 - (place - at)) / r(at);
    u[at + 1] = (place - at) / r(at + 1);
    const double g = 1 - std::numbers::sqrt2 / 2;
    for (int n = 0; n < steps; ++n) {
      const double dt = 0.25 * (2 * n + 1) / (steps * steps);
      const Column first = implicit(laplacian(u, mode), g * dt, mode);
      Column half = u;
      for (int i = 0; i < cells; ++i) half[i] += (1 - g) * dt * first[i];
      const Column second = implicit(laplacian(half, mode), g * dt, mode);
      for (int i = 0; i < cells; ++i) u[i] += dt * ((1 - g) * first[i] + g * second[i]);
    }
    return u;
  }

  double R_, step_;
  Column mode_[3];
};

constexpr double radius = 0.5;
const auto circle = body::circle({}, radius);

/// What a blob adds to the wall vorticity, integrated along the wall.
double at_wall(const Blobs& blobs) {
  double sum = 0;
  for (std::size_t i = 0; i < blobs.size(); ++i) {
    body::WallPoint w = circle->nearest(blobs.centre(i));
    const Covariance v = blobs.core(i).covariance(w.normal);
    w.distance = height(w, v);
    sum += vortex::trace({blobs.gamma[i], w, std::sqrt(2 * v.nn), std::sqrt(2 * v.tt)}).amount;
  }
  return sum;
}

Blobs at(double angle, double y, double s) {
  Blobs one;
  one.append({(radius + y) * std::cos(angle), (radius + y) * std::sin(angle)}, 1, s);
  return one;
}

/// Two blobs at the same distance, an angle apart, as one.
Blobs joined(double angle, double y, double s) {
  Blobs two = at(-angle / 2, y, s);
  const Blobs other = at(angle / 2, y, s);
  two.append(other.centre(0), 1, other.core(0));
  const vortex::Merging all{.tolerance = 1e9, .reach = 1e9, .sigma_max = 1};
  merge_close(two, all, circle.get());
  return two;
}

}  // namespace

TEST_CASE("mean and variance of a core beside a bent wall are the heat flow's to (kappa s)^2") {
  for (const double kappa : {0.2, 0.1})
    for (const double y : {0.0, 0.3, 0.7, 1.0, 1.5}) {
      CAPTURE(kappa, y);
      const Heat heat(1 / kappa, y);
      const vortex::folded::MeanAndVariance m = vortex::folded::moments(y, 1, kappa);
      // The heat flow's own error is a hundredth of a cell's square in space, as much in time.
      CHECK(std::abs(m.mean - heat.mean()) < 0.02 * kappa * kappa + 5e-5);
      CHECK(std::abs(m.across - heat.variance()) < 0.08 * kappa * kappa + 5e-5);
    }
}

TEST_CASE("two cores along a bent wall are one of the same distance and width: they follow it") {
  for (const double y : {0.0, 0.01, 0.03})
    for (const double angle : {0.02, 0.04}) {
      CAPTURE(y, angle);
      const Blobs one = joined(angle, y, 0.03);
      REQUIRE(one.size() == 1);
      const body::WallPoint w = circle->nearest(one.centre(0));
      const Covariance v = one.core(0).covariance(w.normal);
      const double apart = angle * (radius + y);
      CHECK(v.tt == Approx(0.03 * 0.03 / 2 + apart * apart / 4).epsilon(1e-3));
      CHECK(std::sqrt(2 * v.nn) == Approx(0.03).epsilon(2e-3));
      CHECK(std::abs(height(w, v) - y) < (y > 0 ? 0.01 * y : 0.1 * 0.03));
      CHECK(at_wall(one) == Approx(2 * at_wall(at(0, y, 0.03))).epsilon(5e-3));
    }
}
