// GCC 12 takes the undefined lanes of its own AVX-512 intrinsics, as Eigen uses them, for a
// mistake.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wuninitialized"

#include "sph/operators/stencils.hpp"

#include <omp.h>

#include <Eigen/Dense>
#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <numbers>

#include "sph/operators/clouds.hpp"

using namespace vortree;
using namespace vortree::sph;
using namespace vortree::sph::test;

namespace {

constexpr double round_off = std::numeric_limits<double>::epsilon();

double wendland(double q) {
  return q < 1 ? std::pow(1 - q, 6) * (1 + 6 * q + 35.0 / 3 * q * q) : 0;
}

/// The weights of a particle by QR factors of the weighted monomials: no moment is ever formed.
struct TwinFit {
  Eigen::MatrixXd weights;  // of derivatives, a column a neighbor
  double condition = 0;     // of the weighted monomials
};

TwinFit twin(const Cloud& cloud, const Stencils& stencils, std::size_t i, int degree, double reach,
             double cut) {
  const int terms = (degree + 1) * (degree + 2) / 2 - 1;
  const double own = cloud.spacing[i], R = reach * own;
  const auto m = static_cast<Eigen::Index>(stencils.length(i));
  Eigen::MatrixXd a(m, terms);
  Eigen::VectorXd root(m);
  Eigen::Index row = 0;
  stencils.for_each(i, [&](std::size_t j, std::size_t slot) {
    const Vec2 d = stencils.offset(slot);
    const double s = cloud.spacing[j], r = std::hypot(d.x, d.y);
    const double w = std::pow(s / own, 2) * wendland(r / (cut * 0.5 * (own + s)));
    root[row] = std::sqrt(w);
    int k = 0;
    for (int of = 1; of <= degree; ++of)
      for (int b = 0; b <= of; ++b)
        a(row, k++) = root[row] * std::pow(d.x / R, of - b) * std::pow(d.y / R, b);
    ++row;
  });
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(a, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const auto& sigma = svd.singularValues();
  Eigen::MatrixXd inverse = a.colPivHouseholderQr().solve(Eigen::MatrixXd::Identity(m, m));
  const double first = 1 / R, second = first * first;
  const double scale[] = {first, first, 2 * second, second, 2 * second};
  TwinFit of{inverse.topRows(5) * root.asDiagonal(), sigma[0] / sigma[terms - 1]};
  for (int e = 0; e < 5; ++e) of.weights.row(e) *= scale[e];
  return of;
}

/// Well inside, where a fit of degree 4 has neighbors all around.
bool amid(Vec2 at) {
  return std::min({at.x, at.y, 1 - at.x, 1 - at.y}) > 0.25;
}

/// The bits of all weights of all particles, and of what else a cloud's stencils tell.
std::vector<double> all_numbers(const Stencils& stencils) {
  std::vector<double> all;
  for (std::size_t i = 0; i < stencils.size(); ++i) {
    all.push_back(stencils.filling(i));
    stencils.for_each(i, [&](std::size_t j, std::size_t slot) {
      all.push_back(static_cast<double>(j));
      for (int e = 0; e < 5; ++e) all.push_back(stencils.weight(e, slot));
    });
  }
  return all;
}

}  // namespace

TEST_CASE("derivatives are exact on polynomials of the degree, for any places and spacings") {
  for (const OperatorOptions options : {OperatorOptions{2, 2.8, 0}, {4, 3.9, 0}})
    for (const std::uint64_t seed : {1, 2, 3}) {
      const Cloud cloud = uneven_cloud(20, seed, options.degree == 2 ? 0.25 : 0.15);
      Stencils stencils;
      stencils.renew(cloud, options);
      CHECK(stencils.degraded() == 0);
      Chance chance(seed + 10);
      const Polynomial p(options.degree, chance);
      const std::vector<double> f = values(cloud, p);
      for (std::size_t i = 0; i < cloud.size(); ++i) {
        if (options.degree == 4 && !amid(cloud.at(i))) continue;
        const auto found = summed(stencils, f, i), exact = listed(p.slopes(cloud.at(i)));
        double size[5] = {};
        stencils.for_each(i, [&](std::size_t, std::size_t slot) {
          for (int e = 0; e < 5; ++e) size[e] += std::abs(stencils.weight(e, slot));
        });
        // Normal equations lose the square of the condition, below 300 here (next test); f is below
        // 15, as it has 15 terms at most.
        for (int e = 0; e < 5; ++e) {
          CAPTURE(options.degree, seed, i, e);
          REQUIRE(std::abs(found[e] - exact[e]) < 300 * 300 * round_off * 15 * size[e]);
        }
      }
    }
}

TEST_CASE(
    "weights are those of a fit by QR factors, to round-off times the square of its condition") {
  for (const OperatorOptions options : {OperatorOptions{2, 2.8, 0}, {4, 3.9, 0}}) {
    const Cloud cloud = uneven_cloud(18, 5, 0.15);
    Stencils stencils;
    stencils.renew(cloud, options);
    double worst = 0, ill = 0;
    for (std::size_t i = 0; i < cloud.size(); i += 3) {
      if (!amid(cloud.at(i))) continue;
      const TwinFit of = twin(cloud, stencils, i, options.degree, options.reach, options.reach);
      ill = std::max(ill, of.condition);
      Eigen::Index k = 0;
      stencils.for_each(i, [&](std::size_t, std::size_t slot) {
        for (int e = 0; e < 5; ++e) {
          const double size = of.weights.row(e).cwiseAbs().maxCoeff();
          worst = std::max(worst, std::abs(stencils.weight(e, slot) - of.weights(e, k)) / size /
                                      (of.condition * of.condition * round_off));
        }
        ++k;
      });
    }
    CAPTURE(options.degree);
    CHECK(ill < 300);
    CHECK(worst < 14);  // terms of a sum
  }
}

TEST_CASE("near a boundary fits are of degree 2, by neighbors nearer than 2.8 spacings") {
  const OperatorOptions options{4, 3.9, 0};
  Cloud cloud = uneven_cloud(18, 6, 0.15, false);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (std::abs(cloud.x[i] - 0.5) < 0.06) cloud.kind[i] = ParticleKind::wall;
  Stencils stencils;
  stencils.renew(cloud, options);
  int near = 0, far = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!amid(cloud.at(i))) continue;
    bool high = cloud.inside(i);
    stencils.for_each(i, [&](std::size_t j, std::size_t slot) {
      const Vec2 d = stencils.offset(slot);
      if (!cloud.inside(j) && std::hypot(d.x, d.y) <= 2.8 * cloud.spacing[i]) high = false;
    });
    ++(high ? far : near);
    const TwinFit of =
        twin(cloud, stencils, i, high ? 4 : 2, options.reach, high ? options.reach : 2.8);
    Eigen::Index k = 0;
    stencils.for_each(i, [&](std::size_t, std::size_t slot) {
      for (int e = 0; e < 5; ++e) {
        const double size = of.weights.row(e).cwiseAbs().maxCoeff();
        CAPTURE(i, e, high);
        REQUIRE(std::abs(stencils.weight(e, slot) - of.weights(e, k)) <
                14 * of.condition * of.condition * round_off * size);
      }
      ++k;
    });
  }
  CHECK(near > 20);
  CHECK(far > 10);
}

TEST_CASE("particles on a line, and one alone, have finite weights") {
  for (const int n : {1, 2, 3, 9, 17}) {
    Cloud cloud;
    for (int k = 0; k < n; ++k) cloud.add({0.6 * k, 0.8 * k}, 1, ParticleKind::fluid);
    for (const OperatorOptions options : {OperatorOptions{2, 2.8, 0}, {4, 3.9, 0}}) {
      Stencils stencils;
      stencils.renew(cloud, options);
      CHECK(stencils.size() == static_cast<std::size_t>(n));
      CHECK(stencils.degraded() == static_cast<std::size_t>(n));
      for (const double number : all_numbers(stencils)) REQUIRE(std::isfinite(number));
      const std::vector<double> f(cloud.size(), 3);
      for (std::size_t i = 0; i < cloud.size(); ++i)
        for (const double zero : summed(stencils, f, i)) CHECK(zero == 0);
    }
  }
}

TEST_CASE("with too few neighbors first derivatives are exact on linear fields, and lap r^2 is 4") {
  Cloud cloud;
  for (const Vec2 at : {Vec2{0, 0}, Vec2{1, 0.1}, Vec2{-0.2, 0.9}, Vec2{0.9, 1.2}})
    cloud.add(at, 1, ParticleKind::fluid);
  Stencils stencils;
  stencils.renew(cloud, {});
  CHECK(stencils.degraded() == 4);
  CHECK(stencils.least_length() == 3);
  const auto linear = values(cloud, [](Vec2 at) { return 1 + 2 * at.x - 3 * at.y; });
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const auto d = summed(stencils, linear, i);
    CHECK(d[0] == Approx(2).epsilon(1e-13));
    CHECK(d[1] == Approx(-3).epsilon(1e-13));
    const auto square =
        values(cloud, [&](Vec2 at) { return dot(at - cloud.at(i), at - cloud.at(i)); });
    const auto second = summed(stencils, square, i);
    CHECK(second[2] + second[4] == Approx(4).epsilon(1e-13));
    stencils.for_each(i,
                      [&](std::size_t, std::size_t slot) { CHECK(stencils.laplacian(slot) > 0); });
  }
}

TEST_CASE("slots that fill a group hold the particle itself with weights of 0") {
  const Cloud all = uneven_cloud(7, 8);
  for (std::size_t n = 1; n <= all.size(); n += n < 20 ? 1 : 13) {
    Cloud cloud;
    for (std::size_t i = 0; i < n; ++i) cloud.add(all.at(i), all.spacing[i], ParticleKind::fluid);
    Stencils stencils;
    stencils.renew(cloud, {});
    REQUIRE(stencils.groups() == (n + lane_count - 1) / lane_count);
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t group = i / lane_count,
                        longest = stencils.first(group + 1) - stencils.first(group);
      REQUIRE(stencils.length(i) <= longest);
      for (std::size_t k = stencils.length(i); k < longest; ++k) {
        const std::size_t slot = stencils.slot(i) + k * lane_count;
        REQUIRE(stencils.index(slot) == static_cast<std::int32_t>(i));
        for (int e = 0; e < 5; ++e) REQUIRE(stencils.weight(e, slot) == 0);
      }
    }
    // What lies beyond the last particle points to a particle, too.
    for (std::size_t slot = 0; slot < stencils.first(stencils.groups()) * lane_count; ++slot)
      REQUIRE((stencils.index(slot) >= 0 && stencils.index(slot) < static_cast<int>(n)));
  }
}

TEST_CASE(
    "neighbors are those nearer than the mean reach, each once and never the particle itself") {
  const Cloud cloud = uneven_cloud(14, 9);
  const OperatorOptions options{2, 2.8, 0};
  Stencils stencils;
  stencils.renew(cloud, options);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    std::vector<std::size_t> found, expected;
    stencils.for_each(i, [&](std::size_t j, std::size_t slot) {
      found.push_back(j);
      const Vec2 d = stencils.offset(slot);
      CHECK(d.x == cloud.x[j] - cloud.x[i]);
      CHECK(d.y == cloud.y[j] - cloud.y[i]);
    });
    for (std::size_t j = 0; j < cloud.size(); ++j) {
      const Vec2 d = cloud.at(j) - cloud.at(i);
      const double r = options.reach * (cloud.spacing[i] + cloud.spacing[j]) / 2;
      if (j != i && std::hypot(d.x, d.y) < r) expected.push_back(j);
    }
    std::ranges::sort(found);
    REQUIRE(found == expected);
  }
}

TEST_CASE("a lattice of squares and one of hexagons fill the plane to 1 %") {
  const double s = 0.05;
  Cloud hexagons;
  const double a = s * std::sqrt(2 / std::numbers::sqrt3);  // its cells have the area s^2
  for (int j = 0; j < 24; ++j)
    for (int i = 0; i < 20; ++i)
      hexagons.add({(i + 0.5 * (j % 2)) * a, j * a * std::numbers::sqrt3 / 2}, s,
                   ParticleKind::fluid);
  for (const Cloud& cloud : {lattice({0, 0}, {1, 1}, s), hexagons})
    for (const double reach : {2.8, 3.9}) {
      Stencils stencils;
      stencils.renew(cloud, {2, reach, 0});
      int inside = 0;
      for (std::size_t i = 0; i < cloud.size(); ++i)
        if (std::abs(cloud.x[i] - 0.5) < 0.2 && std::abs(cloud.y[i] - 0.5) < 0.2) {
          ++inside;
          CHECK(stencils.filling(i) == Approx(1).margin(0.01));
        }
      CHECK(inside > 40);
    }
}

TEST_CASE("filling is the sum of V W over the neighbors and the particle, W of integral one") {
  const Cloud cloud = uneven_cloud(12, 3);
  Stencils stencils;
  stencils.renew(cloud, {});
  for (std::size_t i = 0; i < cloud.size(); i += 7) {
    const auto part = [&](double s, double h, double r) {
      return s * s / (h * h) * 9 / std::numbers::pi * wendland(r / h);
    };
    const double own = cloud.spacing[i];
    double sum = part(own, 2.8 * own, 0);
    for (std::size_t j = 0; j < cloud.size(); ++j) {
      const Vec2 d = cloud.at(j) - cloud.at(i);
      if (j != i)
        sum += part(cloud.spacing[j], 1.4 * (own + cloud.spacing[j]), std::hypot(d.x, d.y));
    }
    CHECK(stencils.filling(i) == Approx(sum).epsilon(1e-14 * 30));  // of 30 neighbors
  }
}

TEST_CASE("stencils have the same bits for any number of threads") {
  const Cloud cloud = uneven_cloud(24, 4);
  for (const OperatorOptions options : {OperatorOptions{2, 2.8, 0}, {4, 3.9, 0}, {2, 2.8, 1}}) {
    const int before = omp_get_max_threads();
    std::vector<double> one;
    for (const int threads : {1, 2, 5}) {
      omp_set_num_threads(threads);
      Stencils stencils;
      stencils.renew(cloud, options);
      const std::vector<double> numbers = all_numbers(stencils);
      if (one.empty()) one = numbers;
      CHECK(numbers == one);
    }
    omp_set_num_threads(before);
  }
}

TEST_CASE("stencils that are renewed are those that are made anew") {
  Stencils used, fresh;
  used.renew(uneven_cloud(20, 4), {4, 3.9, 1});
  const Cloud cloud = uneven_cloud(9, 11);
  used.renew(cloud, {}), fresh.renew(cloud, {});
  CHECK(all_numbers(used) == all_numbers(fresh));
  CHECK(used.degraded() == fresh.degraded());
  CHECK(used.least_length() == fresh.least_length());
}

TEST_CASE("periodic neighbors are those of a cloud among its copies") {
  const Cloud cloud = uneven_cloud(12, 12);
  Cloud tiles = cloud;
  for (const int a : {-1, 0, 1})
    for (const int b : {-1, 0, 1})
      for (std::size_t i = 0; i < cloud.size(); ++i)
        if (a != 0 || b != 0)
          tiles.add(cloud.at(i) + Vec2{1.0 * a, 1.0 * b}, cloud.spacing[i], ParticleKind::fluid);
  const auto field = [](Vec2 at) {
    return std::sin(2 * std::numbers::pi * at.x) + std::cos(2 * std::numbers::pi * at.y);
  };
  for (const OperatorOptions options : {OperatorOptions{2, 2.8, 1}, {4, 3.9, 1}}) {
    Stencils periodic, open;
    periodic.renew(cloud, options);
    open.renew(tiles, {options.degree, options.reach, 0});
    CHECK(periodic.size() == cloud.size());
    CHECK(periodic.degraded() == 0);
    const std::vector<double> f = values(cloud, field), g = values(tiles, field);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      REQUIRE(periodic.length(i) == open.length(i));
      CHECK(periodic.filling(i) == Approx(open.filling(i)).epsilon(1e-13));
      const auto p = summed(periodic, f, i), q = summed(open, g, i);
      // Places of copies are rounded, and the fits multiply that by the square of their condition.
      for (int e = 0; e < 5; ++e) REQUIRE(p[e] == Approx(q[e]).margin(1e-8));
    }
  }
}
