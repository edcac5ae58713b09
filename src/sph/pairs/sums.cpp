#include "sph/pairs/sums.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "sph/pairs/kernel_shapes.hpp"

namespace vortree::sph {
namespace {

using tree::Listing;
using NeighborRow = std::span<const std::int32_t>;

// Of particle i with others: x_i - x_j and the kernel between them.
template <class Shape>
class ParticlePair {
 public:
  ParticlePair(const SmoothedParticles& particles, double norm, std::size_t i)
      : p_(particles), norm_(norm), x_(p_.points.x[i]), y_(p_.points.y[i]), reach_(p_.reach[i]) {}

  void look_at(std::size_t j) {
    dx = x_ - p_.points.x[j], dy = y_ - p_.points.y[j];
    h_ = 0.5 / Shape::support * (reach_ + p_.reach[j]);
  }

  double value() const { return norm_ / (h_ * h_) * Shape::shape(q()); }
  double slope_over_r() const { return norm_ / (h_ * h_ * h_ * h_) * Shape::slope_over_q(q()); }

  double dx = 0, dy = 0;

 private:
  double q() const { return std::sqrt(dx * dx + dy * dy) / h_; }

  const SmoothedParticles& p_;
  double norm_, x_, y_, reach_, h_ = 0;
};

void check(const SmoothedParticles& p, std::size_t rows) {
  if (p.mass.size() == rows && p.reach.size() == rows && p.points.size() == rows) return;
  throw std::invalid_argument("sph: " + std::to_string(rows) + " rows for " +
                              std::to_string(p.points.size()) + " particles with " +
                              std::to_string(p.mass.size()) + " masses and " +
                              std::to_string(p.reach.size()) + " reaches");
}

template <class Shape>
struct DensitySum {
  const SmoothedParticles& p;
  double norm;
  std::span<double> rho;

  void start() const {
    for (std::size_t i = 0; i < rho.size(); ++i) {
      ParticlePair<Shape> self(p, norm, i);
      self.look_at(i);
      rho[i] = p.reach[i] > 0 ? p.mass[i] * self.value() : 0;
    }
  }

  void add(std::size_t i, NeighborRow row) const {
    ParticlePair<Shape> pair(p, norm, i);
    double sum = 0;
    for (const std::int32_t number : row) {
      const auto j = static_cast<std::size_t>(number);
      pair.look_at(j);
      sum += p.mass[j] * pair.value();
    }
    rho[i] += sum;
  }

  // Also what i gives to the others of its row.
  void add_both(std::size_t i, NeighborRow row) const {
    ParticlePair<Shape> pair(p, norm, i);
    for (const std::int32_t number : row) {
      const auto j = static_cast<std::size_t>(number);
      pair.look_at(j);
      const double w = pair.value();
      rho[i] += p.mass[j] * w, rho[j] += p.mass[i] * w;
    }
  }
};

template <class Shape>
struct GradientSum {
  const SmoothedParticles& p;
  double norm;
  std::span<const double> volume, f;
  std::span<double> gx, gy;

  void start() const { std::ranges::fill(gx, 0), std::ranges::fill(gy, 0); }

  void add(std::size_t i, NeighborRow row) const {
    ParticlePair<Shape> pair(p, norm, i);
    double x = 0, y = 0;
    for (const std::int32_t number : row) {
      const auto j = static_cast<std::size_t>(number);
      pair.look_at(j);
      const double weight = volume[j] * (f[j] - f[i]) * pair.slope_over_r();
      x += weight * pair.dx, y += weight * pair.dy;
    }
    gx[i] += x, gy[i] += y;
  }

  void add_both(std::size_t i, NeighborRow row) const {
    ParticlePair<Shape> pair(p, norm, i);
    for (const std::int32_t number : row) {
      const auto j = static_cast<std::size_t>(number);
      pair.look_at(j);
      const double slope = (f[j] - f[i]) * pair.slope_over_r();
      gx[i] += volume[j] * slope * pair.dx, gy[i] += volume[j] * slope * pair.dy;
      gx[j] += volume[i] * slope * pair.dx, gy[j] += volume[i] * slope * pair.dy;
    }
  }
};

template <class Sum>
void add_rows(const Sum& sum, const tree::PairList& rows, Listing listing) {
  sum.start();
  if (listing == Listing::both_ways) {
#pragma omp parallel for schedule(dynamic, 512)
    for (std::size_t i = 0; i < rows.size(); ++i) sum.add(i, rows.row(i));
    return;
  }
  for (std::size_t i = 0; i < rows.size(); ++i) sum.add_both(i, rows.row(i));
}

template <class Sum>
void add_rows(const Sum& sum, tree::Neighbors& search) {
  sum.start();
  search.visit(tree::PairRule::mean, Listing::both_ways,
               [&](std::int32_t i, NeighborRow row) { sum.add(static_cast<std::size_t>(i), row); });
}

// from  rows and their listing, or a search
template <class... From>
void add_density(const SmoothedParticles& p, std::span<double> rho, From&&... from) {
  with_shape<2>(p.kernel, [&]<class Shape>(Shape) {
    add_rows(DensitySum<Shape>{p, norm(p.kernel, 2), rho}, from...);
  });
}

template <class... From>
void add_gradient(const SmoothedParticles& p, std::span<const double> volume,
                  std::span<const double> f, std::span<double> gx, std::span<double> gy,
                  From&&... from) {
  with_shape<2>(p.kernel, [&]<class Shape>(Shape) {
    add_rows(GradientSum<Shape>{p, norm(p.kernel, 2), volume, f, gx, gy}, from...);
  });
}

}  // namespace

void density(const SmoothedParticles& p, const tree::PairList& rows, Listing listing,
             std::span<double> rho) {
  check(p, rows.size());
  add_density(p, rho, rows, listing);
}

void density(const SmoothedParticles& p, tree::Neighbors& search, std::span<double> rho) {
  check(p, search.placed().size);
  add_density(p, rho, search);
}

void gradient(const SmoothedParticles& p, std::span<const double> volume, std::span<const double> f,
              const tree::PairList& rows, Listing listing, std::span<double> gx,
              std::span<double> gy) {
  check(p, rows.size());
  add_gradient(p, volume, f, gx, gy, rows, listing);
}

void gradient(const SmoothedParticles& p, std::span<const double> volume, std::span<const double> f,
              tree::Neighbors& search, std::span<double> gx, std::span<double> gy) {
  check(p, search.placed().size);
  add_gradient(p, volume, f, gx, gy, search);
}

}  // namespace vortree::sph
