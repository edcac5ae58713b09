#include "fmm/vorticity.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "point_sets.hpp"

using namespace vortree;

namespace {

struct Exact {
  double omega, contributions;
};

Exact exact_vorticity(const test::PointSet& set, const std::vector<double>& sigma, double x,
                      double y) {
  long double omega = 0, contributions = 0;
  for (std::size_t j = 0; j < set.size(); ++j) {
    if (sigma[j] == 0) continue;
    const long double dx = x - static_cast<long double>(set.x[j]);
    const long double dy = y - static_cast<long double>(set.y[j]);
    const long double s2 = static_cast<long double>(sigma[j]) * sigma[j];
    const long double part =
        set.gamma[j] / (std::numbers::pi_v<long double> * s2) * std::exp(-(dx * dx + dy * dy) / s2);
    omega += part;
    contributions += std::abs(part);
  }
  return {static_cast<double>(omega), static_cast<double>(contributions)};
}

}  // namespace

TEST_CASE("vorticity keeps its tolerance of the largest sum of |contributions|") {
  for (const test::PointKind kind : test::every_kind) {
    CAPTURE(test::kind_names[static_cast<int>(kind)]);
    const test::PointSet set = test::make_points(kind, 3000);
    std::vector<double> sigma(set.size(), 0.04);
    for (std::size_t j = 0; j < set.size(); j += 7) sigma[j] = j % 2 == 0 ? 0.0 : 0.2;
    std::vector<double> omega(set.size());
    std::vector<Exact> exact;
    double most = 0.0;
    for (std::size_t i = 0; i < set.size(); i += 50) {
      exact.push_back(exact_vorticity(set, sigma, set.x[i], set.y[i]));
      most = std::max(most, exact.back().contributions);
    }
    for (const double tolerance : {1e-2, 1e-5, 1e-12}) {
      fmm::vorticity({set.x, set.y, set.gamma, sigma}, {set.x, set.y}, omega, tolerance);
      for (std::size_t i = 0; i < set.size(); i += 50) {
        CHECK(std::abs(omega[i] - exact[i / 50].omega) <= tolerance * most);
      }
    }
  }
}

TEST_CASE("the vorticity of one blob is its peak in the middle and circulation over the plane") {
  const std::vector<double> x{1e5}, y{-2e5}, gamma{3}, sigma{0.5};
  std::vector<double> at_x, at_y;
  const double step = 0.05;
  for (int i = -80; i <= 80; ++i) {
    for (int j = -80; j <= 80; ++j) {
      at_x.push_back(1e5 + i * step), at_y.push_back(-2e5 + j * step);
    }
  }
  std::vector<double> omega(at_x.size());
  fmm::vorticity({x, y, gamma, sigma}, {at_x, at_y}, omega, 1e-12);
  double sum = 0.0;
  for (const double value : omega) sum += value * step * step;
  CHECK(sum == Approx(3.0).epsilon(1e-9));
  CHECK(omega[omega.size() / 2] == Approx(3.0 / (std::numbers::pi * 0.25)).epsilon(1e-9));
}

TEST_CASE("bare vortices and no blobs have no vorticity, and wrong questions are refused") {
  const std::vector<double> two{1, 2}, three{1, 2, 3}, none;
  std::vector<double> omega(2, 5.0);
  fmm::vorticity({two, two, two, {}}, {two, two}, omega);
  CHECK(omega == std::vector<double>{0, 0});
  fmm::vorticity({none, none, none, none}, {two, two}, omega);
  CHECK(omega == std::vector<double>{0, 0});
  CHECK_THROWS_WITH(fmm::vorticity({two, two, two, two}, {three, three}, omega),
                    Catch::Matchers::Contains("omega has 2 values, the targets are 3"));
  CHECK_THROWS_WITH(fmm::vorticity({two, two, two, two}, {two, two}, omega, 2.0),
                    Catch::Matchers::Contains("tolerance is 2"));
}
