#include "sph/adapt/population.hpp"

#include <catch2/catch.hpp>
#include <numeric>

#include "sph/operators/clouds.hpp"

using namespace vortree;
using namespace vortree::sph;
using namespace vortree::sph::test;

namespace {

/// Particles that carry polynomials of degree 2, with their stencils and slopes.
struct Carrying {
  Cloud cloud;
  std::vector<Polynomial> fields;
  Stencils stencils;
  std::vector<Slopes> slopes;

  explicit Carrying(Cloud of) : cloud(std::move(of)) {
    Chance chance(5);
    for (const auto field : carried) {
      fields.emplace_back(2, chance);
      cloud.*field = values(cloud, fields.back());
    }
    stencils.renew(cloud, {});
    find_slopes(cloud, stencils, slopes);
  }

  /// Largest difference of what is carried to the fields.
  double error() const {
    double worst = 0;
    for (std::size_t field = 0; field < carried_count; ++field)
      for (std::size_t i = 0; i < cloud.size(); ++i)
        worst = std::max(worst, std::abs((cloud.*carried[field])[i] - fields[field](cloud.at(i))));
    return worst;
  }
};

struct Moments {
  double volume = 0;
  Vec2 moment{};
};

Moments moments(const Cloud& cloud) {
  Moments sum;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    sum.volume += cloud.volume(i), sum.moment += cloud.volume(i) * cloud.at(i);
  return sum;
}

// Fits of condition below 100, whose square is lost, times some 30 roundings of values of order 1.
constexpr double rounding = 1e-10;

}  // namespace

TEST_CASE("a merger keeps volume and centre, and carries quadratic fields exactly") {
  Carrying of(uneven_cloud(10, 51));
  const Moments before = moments(of.cloud);
  const std::size_t n = of.cloud.size();
  Population population(of.cloud, of.stencils, of.slopes);
  int mergers = 0;
  for (std::size_t i = 0; i < n; i += 3) {
    std::size_t partner = i;
    population.for_each_neighbor(i, [&](std::size_t j, Vec2) { partner = j; });
    if (population.gone(i) || partner == i) continue;
    const std::size_t k = population.merge(i, partner);
    CHECK(k >= n);
    CHECK(population.gone(i));
    CHECK(population.gone(partner));
    ++mergers;
  }
  population.finish();
  CHECK(mergers > 20);
  CHECK(of.cloud.size() == n - static_cast<std::size_t>(mergers));
  const Moments after = moments(of.cloud);
  CHECK(after.volume == Approx(before.volume).epsilon(1e-13));
  CHECK(after.moment.x == Approx(before.moment.x).epsilon(1e-13));
  CHECK(after.moment.y == Approx(before.moment.y).epsilon(1e-13));
  CHECK(of.error() < rounding);
}

TEST_CASE("who comes carries what quadratic fields are there; who is gone is nobody's neighbor") {
  Carrying of(uneven_cloud(10, 52));
  const std::size_t n = of.cloud.size();
  Population population(of.cloud, of.stencils, of.slopes);
  CHECK(population.old() == n);
  for (std::size_t i = 0; i < n; i += 4) {
    const double s = of.cloud.spacing[i];
    const std::size_t k = population.add(i, {0.3 * s, -0.2 * s}, 0.7 * s);
    CHECK(population.cloud().free(k));
    CHECK(population.cloud().spacing[k] == 0.7 * s);
    population.remove(i);
  }
  CHECK(population.old() == n);
  for (std::size_t i = 0; i < n; ++i)
    population.for_each_neighbor(i, [&](std::size_t j, Vec2 d) {
      REQUIRE(j < n);
      REQUIRE(j % 4 != 0);
      CHECK(d.x == of.cloud.x[j] - of.cloud.x[i]);
    });
  population.finish();
  CHECK(of.cloud.size() == n);
  CHECK(of.error() < rounding);
}

TEST_CASE("particles that are taken away leave the others in their order, in every column") {
  Carrying of(uneven_cloud(6, 53));
  Cloud& cloud = of.cloud;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    cloud.place[i] = static_cast<std::int32_t>(i), cloud.nx[i] = 2.0 * i, cloud.ny[i] = 3.0 * i;
    if (i % 5 == 0) cloud.kind[i] = ParticleKind::outlet;
  }
  const Cloud before = cloud;
  std::vector<char> gone(cloud.size());
  for (std::size_t i = 0; i < gone.size(); ++i) gone[i] = i % 3 == 1;
  cloud.remove(gone);
  std::size_t k = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (gone[i]) continue;
    CHECK(cloud.place[k] == before.place[i]);
    CHECK(cloud.kind[k] == before.kind[i]);
    CHECK(cloud.x[k] == before.x[i]);
    CHECK(cloud.y[k] == before.y[i]);
    CHECK(cloud.spacing[k] == before.spacing[i]);
    CHECK(cloud.nx[k] == before.nx[i]);
    CHECK(cloud.ny[k] == before.ny[i]);
    for (const auto field : carried) CHECK((cloud.*field)[k] == (before.*field)[i]);
    ++k;
  }
  CHECK(k == cloud.size());
}

TEST_CASE("sorting changes the order of particles alone, the same for all that they carry") {
  Carrying of(uneven_cloud(12, 54));
  const Moments before = moments(of.cloud);
  const std::size_t n = of.cloud.size();
  std::iota(of.cloud.place.begin(), of.cloud.place.end(), 0);
  const Cloud old = of.cloud;
  sort(of.cloud);
  std::vector<char> seen(n, 0);
  for (std::size_t k = 0; k < n; ++k) {
    const auto i = static_cast<std::size_t>(of.cloud.place[k]);
    CHECK_FALSE(seen[i]);
    seen[i] = 1;
    CHECK(of.cloud.x[k] == old.x[i]);
    CHECK(of.cloud.y[k] == old.y[i]);
    CHECK(of.cloud.spacing[k] == old.spacing[i]);
  }
  CHECK(of.error() == 0);
  CHECK(moments(of.cloud).volume == Approx(before.volume).epsilon(1e-13));
  double old_steps = 0, steps = 0;
  for (std::size_t k = 1; k < n; ++k) {
    const Vec2 a = old.at(k) - old.at(k - 1), b = of.cloud.at(k) - of.cloud.at(k - 1);
    old_steps += std::hypot(a.x, a.y), steps += std::hypot(b.x, b.y);
  }
  CHECK(steps < 2 * old_steps);  // near in memory, as columns of a lattice are
}
