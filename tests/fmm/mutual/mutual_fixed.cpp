#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "fmm/direct.hpp"
#include "fmm/mutual/mutual_fixed_kernel.hpp"
#include "fmm/plan.hpp"
#include "point_sets.hpp"
#include "tree/base/memory.hpp"

using namespace vortree;

namespace {

constexpr std::size_t n = single_count;

/// Whole numbers spread over the side of a cell whose middle is x, y.
struct Spread {
  Unwritten<std::int32_t> x, y;
  Unwritten<float> gamma;

  Spread(std::size_t size, double middle_x, double middle_y, test::Uniform& uniform)
      : x(padded(size, n)), y(x.size()), gamma(x.size()) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      const auto place = [&](double middle) {
        return static_cast<std::int32_t>((middle + uniform() - 0.5) * fmm::fixed_side);
      };
      x[i] = i < size ? place(middle_x) : 1 << 30, y[i] = place(middle_y);
      gamma[i] = i < size ? static_cast<float>(2 * uniform() - 1) : 0.0f;
    }
  }
};

struct Sums {
  std::vector<double> u, v, whole;  // whole: of magnitudes
  explicit Sums(std::size_t size) : u(size), v(size), whole(size) {}
  void add(std::size_t i, double gamma, double dx, double dy) {
    const double w = fmm::fixed_pair_plain(dx, dy);
    u[i] -= gamma * w * dy, v[i] += gamma * w * dx;
    whole[i] += std::abs(gamma * w) * std::hypot(dx, dy);
  }
};

/// What the points of `from` do to those of `to`, pair by pair.
Sums plain(const Spread& to, const Spread& from) {
  Sums sums(to.x.size());
  for (std::size_t i = 0; i < to.x.size(); ++i) {
    for (std::size_t j = 0; j < from.x.size(); ++j) {
      sums.add(i, from.gamma[j], static_cast<double>(to.x[i]) - from.x[j],
               static_cast<double>(to.y[i]) - from.y[j]);
    }
  }
  return sums;
}

struct Room {
  Unwritten<Singles> u, v;
  explicit Room(std::size_t size) : u(size), v(size) {
    std::fill(u.begin(), u.end(), Singles{});
    std::fill(v.begin(), v.end(), Singles{});
  }
  fmm::FixedCell cell(const Spread& points, std::size_t size) {
    return {points.x.data(), points.y.data(), points.gamma.data(), u.data(), v.data(), size};
  }
};

double from_plain(double sum, double exact, double whole) {
  return whole == 0.0 ? std::abs(sum) : std::abs(sum - exact) / whole;
}

}  // namespace

TEST_CASE("near sums in fixed point equal those pair by pair to 2^-22") {
  test::Uniform uniform(5);
  for (const std::size_t size : {1u, 7u, 8u, 21u}) {
    for (int round = 0; round < 20; ++round) {
      const Spread own(size, 0, 0, uniform), others(n, 1.1, round % 3, uniform);
      Room room(own.x.size());
      fmm::FixedOthers met{
          load(others.x.data()), load(others.y.data()), load(others.gamma.data()), {}, {}};
      CHECK_FALSE(fmm::meet_fixed<true>(room.cell(own, size), met));
      const Sums upon_own = plain(own, others), upon_others = plain(others, own);
      for (std::size_t i = 0; i < size; ++i) {
        CHECK(from_plain(sum(room.u[i]), upon_own.u[i], upon_own.whole[i]) < 0x1p-22);
        CHECK(from_plain(sum(room.v[i]), upon_own.v[i], upon_own.whole[i]) < 0x1p-22);
      }
      for (std::size_t j = 0; j < n; ++j) {
        CHECK(from_plain(met.u[j], upon_others.u[j], upon_others.whole[j]) < 0x1p-22);
        CHECK(from_plain(met.v[j], upon_others.v[j], upon_others.whole[j]) < 0x1p-22);
      }
    }
  }
}

TEST_CASE("a cell meets itself in fixed point as pair by pair, and tells pairs that are too near") {
  test::Uniform uniform(7);
  for (const std::size_t size : {1u, 2u, 8u, 9u, 30u}) {
    for (int round = 0; round < 20; ++round) {
      Spread own(size, 0, 0, uniform);
      if (round == 19) own.x[0] = own.x[size - 1], own.y[0] = own.y[size - 1] + (1 << 19);
      bool near = false;
      for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          near = near || std::hypot(static_cast<double>(own.x[i]) - own.x[j],
                                    static_cast<double>(own.y[i]) - own.y[j]) < fmm::fixed_near;
        }
      }
      Room room(own.x.size());
      CHECK(fmm::meet_itself(room.cell(own, size)) == near);
      const Sums exact = plain(own, own);
      for (std::size_t i = 0; i < size; ++i) {
        CHECK(from_plain(sum(room.u[i]), exact.u[i], exact.whole[i]) < 0x1p-22);
        CHECK(from_plain(sum(room.v[i]), exact.v[i], exact.whole[i]) < 0x1p-22);
      }
    }
  }
}

TEST_CASE("pairs nearer than fixed point tells apart keep the tolerance") {
  test::Uniform uniform(11);
  for (int bits = 4; bits <= 50; bits += 2) {
    CAPTURE(bits);
    test::PointSet set;
    for (int i = 0; i < 2000; ++i) {
      // In every second case cells of many sizes side by side.
      const double stretch = bits % 4 == 0 ? 1.0 : std::exp2(-10 * uniform());
      const double x = stretch * uniform(), y = uniform();
      const double angle = 6.3 * uniform(), distance = std::exp2(-bits);
      set.x.insert(set.x.end(), {x, x + distance * std::cos(angle)});
      set.y.insert(set.y.end(), {y, y + distance * std::sin(angle)});
      set.gamma.insert(set.gamma.end(), {2 * uniform() - 1, 2 * uniform() - 1});
    }
    std::vector<double> u(set.size()), v(u), exact_u(u), exact_v(u);
    fmm::Plan(set.blobs(), {.tolerance = 1e-6}).velocity(u, v);
    fmm::velocity_direct(set.blobs(), {set.x, set.y, {}}, fmm::Cores::mean, exact_u, exact_v);
    double wrong = 0, whole = 0;
    for (std::size_t i = 0; i < set.size(); ++i) {
      wrong += std::pow(u[i] - exact_u[i], 2) + std::pow(v[i] - exact_v[i], 2);
      whole += std::pow(exact_u[i], 2) + std::pow(exact_v[i], 2);
    }
    CHECK(std::sqrt(wrong / whole) < 1e-6);
  }
}
