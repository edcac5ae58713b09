#include "vortex/adapt/lattice/lay_along_wall.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "vortex/adapt/lattice/units.hpp"
#include "vortex/adapt/tuning.hpp"
#include "vortex/cores/folded_core.hpp"

namespace vortree::vortex {

WallLattice::WallLattice(double sigma_max, double spread) {
  const double widest = lattice_step * sigma_max;
  step = spread > 0 ? std::min(std::sqrt(1.5 * spread), widest) : widest;
  square = std::pow(lattice_core / lattice_step * step, 2);
}

bool WallLattice::takes(const Core& core, const body::WallPoint& nearest) const {
  const double strain = 2 * core.deviator.size();
  return core.square - strain >= narrowest_laid * square &&
         core.square + strain <= square + 2 * widest_laid * step * step &&
         std::abs(nearest.curvature) * step <= sharpest_followed;
}

bool WallLattice::fits(const body::Shape& wall) const {
  return std::ranges::max(wall.perimeters()) < most_columns * step;
}

int SpreadShares::reach_of(double V) {
  return V > 0.5 ? std::min(most, static_cast<int>(std::ceil(4 * std::sqrt(V)))) : 1;
}

SpreadShares::SpreadShares(double d, double V) : reach_(reach_of(V)) {
  double sum = 0, mean = 0, square = 0;
  for (int k = -reach_; V > 0.5 && k <= reach_; ++k) {
    const double x = k - d, w = std::exp(-x * x / (2 * V)) / std::sqrt(2 * std::numbers::pi * V);
    share_[most + k] = w;
    sum += w;
    mean += w * k;
    square += w * k * k;
  }
  // What is missing of the sum, and of the moments about node 0.
  const double m0 = 1 - sum, m1 = d - mean, m2 = V + d * d - square;
  share_[most - 1] += (m2 - m1) / 2;
  share_[most] += m0 - m2;
  share_[most + 1] += (m2 + m1) / 2;
}

namespace {

/// The stretch of a wall that is one closed curve.
struct WallCurve {
  double arc, perimeter;
};

/// The nodes that there may be along one of its curves.
class WallNodes {
 public:
  WallNodes(const WallLattice& lattice, const body::Shape& wall, const WallCurve& curve,
            std::int64_t rows, double strength)
      : columns_(
            std::max<std::int64_t>(least_columns, std::llround(curve.perimeter / lattice.step))),
        rows_(rows),
        arc_(curve.arc),
        b_(curve.perimeter / static_cast<double>(columns_)),
        h_(lattice.step),
        core_{lattice.square},
        units_(strength),
        sum_(columns_ * rows_),
        foot_(columns_),
        normal_(columns_),
        at_wall_(columns_ * rows_) {
#pragma omp parallel for schedule(static)
    for (std::int64_t k = 0; k < columns_; ++k) set_up_column(k, wall);
  }

  void lay(const WideAtWall& blob) {
    const AtWall acts = beside(blob.nearest, blob.core);
    const Covariance v = blob.core.covariance(blob.nearest.normal);
    const double y = height(blob.nearest, v) / h_, arc = (blob.nearest.arc - arc_) / b_;
    // Along the wall, as far from it as the blob acts.
    const double step = b_ * std::max(1 + blob.nearest.curvature * acts.mean, 0.25);
    const auto k = static_cast<std::int64_t>(std::nearbyint(arc)),
               j = std::max<std::int64_t>(static_cast<std::int64_t>(std::nearbyint(y)), 0);
    const double own = core_.square / 2;
    const SpreadShares along(arc - static_cast<double>(k), (v.tt - own) / (step * step)),
        across(y - static_cast<double>(j), (v.nn - own) / (h_ * h_));
    OneBlob one{*this, units_.of(blob.gamma), blob.centre + acts.offset};
    for (int a = -along.reach(); a <= along.reach(); ++a)
      for (int r = -across.reach(); r <= across.reach(); ++r)
        one.put(k + a, std::abs(j + r), along[a] * across[r]);
    one.tilt(k, j, v.nt / step);
    one.make_up(k, j);
  }

  void append_to(AdaptedBlobs& adapted) const {
    for (std::int64_t k = 0; k < columns_; ++k)
      for (std::int64_t j = 0; j < rows_; ++j) {
        const std::int64_t sum = sum_[k * rows_ + j];
        if (sum == 0) continue;
        const Vec2 at = place(k, j);
        const auto slot = static_cast<std::uint32_t>(adapted.at_wall.size());
        adapted.at_wall.push_back(at_wall_[k * rows_ + j]);
        adapted.all.push_back({at.x,
                               at.y,
                               units_.circulation(sum),
                               core_.square,
                               {},
                               slot,
                               1,
                               static_cast<float>(lattice_leniency)});
      }
  }

 private:
  /// What nodes get of a blob, and what their centroids still miss of its own.
  struct OneBlob {
    WallNodes& nodes;
    std::int64_t units;
    Vec2 missed;  // of the centroid
    std::int64_t left = units;

    void put(std::int64_t k, std::int64_t j, double share) {
      k = nodes.around(k);
      const std::int64_t part = std::llrint(static_cast<double>(units) * share);
      missed = missed - share * nodes.centroid(k, j);
      left -= part;
      nodes.add(k, j, part);
    }
    /// From one node to another.
    void shift(std::int64_t from_k, std::int64_t from_j, std::int64_t to_k, std::int64_t to_j,
               double share) {
      put(from_k, from_j, -share);
      put(to_k, to_j, share);
    }
    /// The row below, or that on the wall.
    static std::int64_t below(std::int64_t j) { return std::max<std::int64_t>(j - 1, 0); }
    void tilt(std::int64_t k, std::int64_t j, double tilt) {
      const std::int64_t low = below(j), at = nodes.around(k);
      const double share = tilt / (2 * (nodes.mean(at, j + 1) - nodes.mean(at, low)));
      for (int a : {-1, 1}) shift(k + a, low, k + a, j + 1, a * share);
    }
    /// Solves by_n n + by_t t = missed; what roundings have left goes to the middle.
    void make_up(std::int64_t k, std::int64_t j) {
      const std::int64_t low = below(j);
      const auto at = [&](int a) { return nodes.around(k + a); };
      const Vec2 n = nodes.centroid(at(0), j + 1) - nodes.centroid(at(0), low),
                 t = nodes.centroid(at(1), j) - nodes.centroid(at(-1), j), d = missed;
      const double area = n.x * t.y - n.y * t.x;
      shift(k, low, k, j + 1, (d.x * t.y - d.y * t.x) / area);
      shift(k - 1, j, k + 1, j, (n.x * d.y - n.y * d.x) / area);
      nodes.add(at(0), j, left);
    }
  };

  void set_up_column(std::int64_t k, const body::Shape& wall) {
    foot_[k] = wall.point(arc_ + static_cast<double>(k) * b_);
    body::WallPoint at = wall.nearest(foot_[k]);
    normal_[k] = at.normal;
    for (std::int64_t j = 0; j < rows_; ++j) {
      at.distance = static_cast<double>(j) * h_;
      at_wall_[k * rows_ + j] = beside(at, core_);
    }
  }

  void add(std::int64_t k, std::int64_t j, std::int64_t units) {
    std::int64_t& sum = sum_[k * rows_ + j];
#pragma omp atomic
    sum += units;
  }

  std::int64_t around(std::int64_t k) const {
    return (k % columns_ + columns_) % columns_;
  }
  double mean(std::int64_t k, std::int64_t j) const {
    return at_wall_[k * rows_ + j].mean;
  }
  Vec2 place(std::int64_t k, std::int64_t j) const {
    return foot_[k] + (static_cast<double>(j) * h_) * normal_[k];
  }
  Vec2 centroid(std::int64_t k, std::int64_t j) const {
    return place(k, j) + at_wall_[k * rows_ + j].offset;
  }

  std::int64_t columns_, rows_;
  double arc_, b_, h_;
  Core core_;
  CirculationUnits units_;
  std::vector<std::int64_t> sum_;
  std::vector<Vec2> foot_, normal_;
  std::vector<AtWall> at_wall_;
};

/// Rows that a blob may reach, and the one after them that makes up.
std::int64_t rows_of(const WideAtWall& blob, const WallLattice& lattice) {
  const Covariance v = blob.core.covariance(blob.nearest.normal);
  const double h = lattice.step, y = std::abs(height(blob.nearest, v));
  const double V = (v.nn - lattice.square / 2) / (h * h);
  return std::max<std::int64_t>(static_cast<std::int64_t>(y / h + 0.5), 0) +
         SpreadShares::reach_of(V) + 3;
}

}  // namespace

namespace {

void lay_along_curve(AdaptedBlobs& adapted, std::span<const WideAtWall> blobs,
                     const WallLattice& lattice, const body::Shape& wall, const WallCurve& curve) {
  if (blobs.empty()) return;
  double strength = 0;
  std::int64_t rows = 0;
  for (const WideAtWall& blob : blobs) {
    strength += std::abs(blob.gamma);
    rows = std::max(rows, rows_of(blob, lattice));
  }
  WallNodes nodes(lattice, wall, curve, rows, strength);
  const std::ptrdiff_t n = std::ssize(blobs);
#pragma omp parallel for schedule(dynamic, wall_blobs_a_turn)
  for (std::ptrdiff_t i = 0; i < n; ++i) nodes.lay(blobs[i]);
  nodes.append_to(adapted);
}

}  // namespace

void lay_along_wall(AdaptedBlobs& adapted, std::span<const WideAtWall> blobs,
                    const WallLattice& lattice, const body::Shape& wall) {
  const std::vector<double> perimeters = wall.perimeters();
  if (perimeters.size() == 1)
    return lay_along_curve(adapted, blobs, lattice, wall, {0, perimeters[0]});
  std::vector<WideAtWall> own;
  double arc = 0;
  for (std::size_t k = 0; k < perimeters.size(); ++k) {
    own.clear();
    std::ranges::copy_if(blobs, std::back_inserter(own), [&](const WideAtWall& blob) {
      return wall.curve_at(blob.nearest.arc) == k;
    });
    lay_along_curve(adapted, own, lattice, wall, {arc, perimeters[k]});
    arc += perimeters[k];
  }
}

}  // namespace vortree::vortex
