#include "vortex/wall/vorticity.hpp"

#include <catch2/catch.hpp>

#include "body/shapes/circle.hpp"
#include "vortex/flows.hpp"

using namespace vortree;
using vortex::Blobs;

namespace {

constexpr double pi = std::numbers::pi, radius = 0.5;

double gaussian(Vec2 d, double gamma, double sigma) {
  return gamma / (pi * sigma * sigma) * std::exp(-dot(d, d) / (sigma * sigma));
}

/// All blobs and all their images in the circle, whether near or not.
double all_of(const Blobs& blobs, const body::Shape* wall, Vec2 at) {
  if (wall && wall->nearest(at).distance < 0) return 0;
  double sum = 0;
  for (std::size_t i = 0; i < blobs.size(); ++i) {
    sum += gaussian(at - blobs.centre(i), blobs.gamma[i], blobs.sigma[i]);
    if (!wall) continue;
    const body::WallPoint w = wall->nearest(blobs.centre(i));
    const Vec2 image = blobs.centre(i) - (2 * w.distance) * w.normal;
    sum += gaussian(at - image, blobs.gamma[i], blobs.sigma[i]);
  }
  return sum;
}

/// The largest difference to the sum over all, relative to the strongest single core.
double difference(const Blobs& blobs, const body::Shape* wall, const test::PointSet& at) {
  std::vector<double> omega(at.size(), 1e300);
  vorticity(blobs, wall, {at.x, at.y}, omega);
  double largest = 0, peak = 0;
  for (std::size_t i = 0; i < blobs.size(); ++i)
    peak = std::max(peak, std::abs(gaussian({}, blobs.gamma[i], blobs.sigma[i])));
  for (std::size_t k = 0; k < at.size(); ++k)
    largest = std::max(largest, std::abs(omega[k] - all_of(blobs, wall, {at.x[k], at.y[k]})));
  return largest / peak;
}

/// Circulation of one blob by Simpson's rule over the fluid outside the circle, seen from the wall.
double circulation_in_fluid(double distance, double sigma) {
  const auto wall = body::circle({}, radius);
  Blobs blobs;
  blobs.append({radius + distance, 0}, 1, sigma);
  constexpr int across = 400, along = 400;
  const double deep = distance + 6 * sigma, wide = 7 * sigma / radius;
  std::vector<double> x, y, weight;
  for (int j = 0; j <= across; ++j) {
    const double r = radius * (1 + 1e-15) + deep * j / across;
    const double simpson = (j == 0 || j == across ? 1 : j % 2 ? 4 : 2) * deep / (3.0 * across);
    for (int i = -along / 2; i <= along / 2; ++i) {
      const double theta = 2 * wide * i / along;
      x.push_back(r * std::cos(theta));
      y.push_back(r * std::sin(theta));
      weight.push_back(simpson * r * 2 * wide / along);
    }
  }
  std::vector<double> omega(x.size());
  vorticity(blobs, wall.get(), {x, y}, omega);
  double sum = 0;
  for (std::size_t k = 0; k < x.size(); ++k) sum += weight[k] * omega[k];
  return sum;
}

}  // namespace

TEST_CASE("vorticity is the sum of all cores, cut where they fall to 1e-10") {
  const test::PointSet at = test::make_points(test::PointKind::uniform, 1000);
  const Blobs blobs = test::cloud(500, 0.01, 0.1);
  CHECK(difference(blobs, nullptr, at) < 500 * 1e-10);
}

TEST_CASE("next to a wall vorticity is the sum of all cores and all images, and none in the body") {
  const auto wall = body::circle({}, radius);
  const test::PointSet at = test::make_points(test::PointKind::ringwake, 1000);
  const Blobs blobs = test::layer(500, radius, 0.2, 0.005, 0.03);
  CHECK(difference(blobs, wall.get(), at) < 500 * 2e-7);  // images end where folding does: exp(-16)
  std::vector<double> omega{1, 1};
  vorticity(blobs, wall.get(), {std::vector{0.0, 0.49}, std::vector{0.0, 0.0}}, omega);
  CHECK(omega == std::vector<double>{0, 0});
}

TEST_CASE("no blobs, no vorticity") {
  std::vector<double> omega{1, 1};
  vortex::vorticity({}, nullptr, {std::vector{0.0, 1.0}, std::vector{0.0, 1.0}}, omega);
  CHECK(omega == std::vector<double>{0, 0});
}

TEST_CASE("the fluid holds all of a blob's circulation, but for its core over the radius") {
  CHECK(circulation_in_fluid(0.2, 0.04) == Approx(1).epsilon(1e-6));  // free
  for (double cores : {0.0, 0.5, 1.5}) {
    const double wide = circulation_in_fluid(cores * 0.04, 0.04) - 1;
    const double thin = circulation_in_fluid(cores * 0.02, 0.02) - 1;
    INFO(cores << " cores from the wall: " << wide << " " << thin);
    CHECK(std::abs(wide) < 0.3 * 0.04 / radius);
    CHECK(std::log2(wide / thin) == Approx(1).margin(0.1));
  }
  // On the wall the curve leaves the core 1 + sigma/(2 sqrt(pi) R) of itself.
  CHECK(circulation_in_fluid(0, 0.01) - 1 ==
        Approx(0.01 / (2 * std::sqrt(pi) * radius)).epsilon(0.02));
}
