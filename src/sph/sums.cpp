#include "sph/sums.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace vortree::sph {
namespace {

using tree::Listing;
using Row = std::span<const std::int32_t>;

constexpr double c6 = 78 / (28 * std::numbers::pi);

double power7(double t) {
  const double t2 = t * t, t4 = t2 * t2;
  return t4 * t2 * t;
}

// W, with q = r / h and t = 1 - q / 2.
double wendland(double r2, double h) {
  const double q = std::sqrt(r2) / h, t = std::max(0.0, 1 - q / 2);
  return c6 / (h * h) * power7(t) * t * (((4 * q + 6.25) * q + 4) * q + 1);
}

// dW/dr / r: the slope of W is -11/2 q (1 - q/2)^7 (4 q^2 + 3.5 q + 1), without the norm.
double wendland_slope(double r2, double h) {
  const double q = std::sqrt(r2) / h, t = std::max(0.0, 1 - q / 2);
  return -5.5 * c6 / (h * h * h * h) * power7(t) * ((4 * q + 3.5) * q + 1);
}

// Of particle i with others.
class Pair {
 public:
  Pair(const Sources& particles, std::size_t i)
      : p_(particles), x_(p_.points.x[i]), y_(p_.points.y[i]), reach_(p_.reach[i]) {}

  void look_at(std::size_t j) {
    dx = x_ - p_.points.x[j], dy = y_ - p_.points.y[j];
    r2 = dx * dx + dy * dy;
    h = (reach_ + p_.reach[j]) / 4;
  }

  double dx = 0, dy = 0, r2 = 0, h = 0;

 private:
  const Sources& p_;
  double x_, y_, reach_;
};

void check(const Sources& p, std::size_t rows) {
  if (p.mass.size() == rows && p.reach.size() == rows && p.points.size() == rows) return;
  throw std::invalid_argument("sph: " + std::to_string(rows) + " rows for " +
                              std::to_string(p.points.size()) + " particles with " +
                              std::to_string(p.mass.size()) + " masses and " +
                              std::to_string(p.reach.size()) + " reaches");
}

void start_density(const Sources& p, std::span<double> rho) {
  for (std::size_t i = 0; i < rho.size(); ++i) {
    rho[i] = p.reach[i] > 0 ? p.mass[i] * wendland(0, p.reach[i] / 2) : 0;
  }
}

void add_density(const Sources& p, std::size_t i, Row row, std::span<double> rho) {
  Pair pair(p, i);
  double sum = 0;
  for (const std::int32_t j : row) {
    pair.look_at(static_cast<std::size_t>(j));
    sum += p.mass[static_cast<std::size_t>(j)] * wendland(pair.r2, pair.h);
  }
  rho[i] += sum;
}

struct Gradient {
  const Sources& p;
  std::span<const double> volume, f;
  std::span<double> gx, gy;

  void add(std::size_t i, Row row) const {
    Pair pair(p, i);
    double x = 0, y = 0;
    for (const std::int32_t number : row) {
      const auto j = static_cast<std::size_t>(number);
      pair.look_at(j);
      const double weight = volume[j] * (f[j] - f[i]) * wendland_slope(pair.r2, pair.h);
      x += weight * pair.dx, y += weight * pair.dy;
    }
    gx[i] += x, gy[i] += y;
  }

  // Also what i gives to the others of its row.
  void add_both(std::size_t i, Row row) const {
    Pair pair(p, i);
    for (const std::int32_t number : row) {
      const auto j = static_cast<std::size_t>(number);
      pair.look_at(j);
      const double slope = (f[j] - f[i]) * wendland_slope(pair.r2, pair.h);
      gx[i] += volume[j] * slope * pair.dx, gy[i] += volume[j] * slope * pair.dy;
      gx[j] += volume[i] * slope * pair.dx, gy[j] += volume[i] * slope * pair.dy;
    }
  }
};

}  // namespace

void density(const Sources& p, const tree::PairList& rows, Listing listing, std::span<double> rho) {
  check(p, rows.size());
  start_density(p, rho);
  if (listing == Listing::both_ways) {
#pragma omp parallel for schedule(dynamic, 512)
    for (std::size_t i = 0; i < rows.size(); ++i) add_density(p, i, rows.row(i), rho);
    return;
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Pair pair(p, i);
    for (const std::int32_t number : rows.row(i)) {
      const auto j = static_cast<std::size_t>(number);
      pair.look_at(j);
      const double w = wendland(pair.r2, pair.h);
      rho[i] += p.mass[j] * w, rho[j] += p.mass[i] * w;
    }
  }
}

void density(const Sources& p, tree::Neighbors& search, std::span<double> rho) {
  check(p, search.placed().size);
  start_density(p, rho);
  search.visit(tree::PairRule::mean, Listing::both_ways, [&](std::int32_t i, Row row) {
    add_density(p, static_cast<std::size_t>(i), row, rho);
  });
}

void gradient(const Sources& p, std::span<const double> volume, std::span<const double> f,
              const tree::PairList& rows, Listing listing, std::span<double> gx,
              std::span<double> gy) {
  check(p, rows.size());
  std::ranges::fill(gx, 0), std::ranges::fill(gy, 0);
  const Gradient sum{p, volume, f, gx, gy};
  if (listing == Listing::both_ways) {
#pragma omp parallel for schedule(dynamic, 512)
    for (std::size_t i = 0; i < rows.size(); ++i) sum.add(i, rows.row(i));
    return;
  }
  for (std::size_t i = 0; i < rows.size(); ++i) sum.add_both(i, rows.row(i));
}

void gradient(const Sources& p, std::span<const double> volume, std::span<const double> f,
              tree::Neighbors& search, std::span<double> gx, std::span<double> gy) {
  check(p, search.placed().size);
  std::ranges::fill(gx, 0), std::ranges::fill(gy, 0);
  const Gradient sum{p, volume, f, gx, gy};
  search.visit(tree::PairRule::mean, Listing::both_ways,
               [&](std::int32_t i, Row row) { sum.add(static_cast<std::size_t>(i), row); });
}

}  // namespace vortree::sph
