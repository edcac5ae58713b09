#include "sph/operators/stencils.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "sph/operators/fit_kernel.hpp"
#include "sph/operators/gather_kernel.hpp"
#include "sph/operators/sight.hpp"
#include "sph/operators/tuning.hpp"

namespace vortree::sph {
namespace {

/// Wendland's C4 without its norm.
Lanes wendland(Lanes q) {
  const Lanes t = larger(1.0 - q, Lanes{}), t2 = t * t;
  return t2 * t2 * t2 * (1.0 + q * (6.0 + 35.0 / 3 * q));
}

/// Its norm in the plane, for a support of radius 1.
constexpr double wendland_norm = 9 / std::numbers::pi;

Bits bits(LaneSet lanes) {
  Bits of{};
  for (int lane = 0; lane < lane_count; ++lane) of[lane] = lanes >> lane & 1u ? -1 : 0;
  return of;
}

/// Some lanes of what is stored, the others stay.
void store_some(double* to, Lanes a, Bits lanes) {
  store(to, lanes ? a : load(to));
}

/// The particles of a group while their weights are made.
struct FitGroup {
  const double *dx, *dy;
  std::array<double*, 5> weight;
  std::size_t slots;
  Lanes reach;                    // of the particles
  std::vector<Lanes> half_reach;  // half the sum of both, of a slot
  std::vector<Lanes> volume;      // (s_j/s_i)^2

  Lanes x(std::size_t k) const { return load(dx + k * lane_count); }
  Lanes y(std::size_t k) const { return load(dy + k * lane_count); }
  Lanes distance(std::size_t k) const { return root(x(k) * x(k) + y(k) * y(k)); }
  Lanes smoothing(std::size_t k, double cut) const {
    return volume[k] * wendland(distance(k) / (cut * half_reach[k]));
  }
};

/// Weights of a degree for some lanes, by neighbors nearer than `cut` of their reach. Returns those
/// for which it could not be done.
template <int degree>
LaneSet fit_lanes(const FitGroup& group, double cut, LaneSet lanes) {
  Fit<degree> fit;
  const Lanes inverse = 1.0 / group.reach;
  for (std::size_t k = 0; k < group.slots; ++k)
    fit.add(group.x(k) * inverse, group.y(k) * inverse, group.smoothing(k, cut));
  const LaneSet failed = fit.solve(least_pivot) & lanes;
  const Bits chosen = bits(lanes & ~failed);
  const Lanes second = inverse * inverse;
  const std::array<Lanes, 5> scale{inverse, inverse, 2.0 * second, second, 2.0 * second};
  for (std::size_t k = 0; k < group.slots; ++k) {
    const auto of =
        fit.weights(group.x(k) * inverse, group.y(k) * inverse, group.smoothing(k, cut));
    for (int e = 0; e < 5; ++e)
      store_some(group.weight[e] + k * lane_count, of[e] * scale[e], chosen);
  }
  return failed;
}

/// First derivatives of degree 1, or none; second ones with positive weights that are exact for the
/// Laplacian of r^2.
void fit_poorly(const FitGroup& group, LaneSet lanes) {
  const Bits chosen = bits(lanes);
  Lanes xx{}, xy{}, yy{};
  for (std::size_t k = 0; k < group.slots; ++k) {
    const Lanes w = group.smoothing(k, 1), x = group.x(k), y = group.y(k);
    xx += w * x * x, xy += w * x * y, yy += w * y * y;
  }
  const Lanes determinant = xx * yy - xy * xy, trace = xx + yy;
  const Bits sound = determinant > least_pivot * trace * trace;
  const Lanes inverse = sound ? 1.0 / (sound ? determinant : fill(1.0)) : Lanes{};
  const Lanes second = trace > Lanes{} ? 2.0 / trace : Lanes{};
  for (std::size_t k = 0; k < group.slots; ++k) {
    const Lanes w = group.smoothing(k, 1), x = group.x(k), y = group.y(k);
    const std::array<Lanes, 5> of{w * inverse * (yy * x - xy * y), w * inverse * (xx * y - xy * x),
                                  w * second, Lanes{}, w * second};
    for (int e = 0; e < 5; ++e) store_some(group.weight[e] + k * lane_count, of[e], chosen);
  }
}

/// F of the kernel: -W'(r)/r.
Lanes kernel_slope(const FitGroup& group, std::size_t k) {
  const Lanes reach = group.half_reach[k], q = group.distance(k) / reach;
  const Lanes t = larger(1.0 - q, Lanes{}), t2 = t * t, r2 = reach * reach;
  return wendland_norm * 56 / 3 / (r2 * r2) * t2 * t2 * t * (1.0 + 5.0 * q);
}

/// The weights of pair sums. Where the correction of the gradient cannot be had, it is left out.
void sum_pairs(const FitGroup& group, Lanes spacing, LaneSet lanes) {
  const Bits chosen = bits(lanes);
  Lanes xx{}, xy{}, yy{};
  const Lanes own = spacing * spacing;
  for (std::size_t k = 0; k < group.slots; ++k) {
    const Lanes w = own * group.volume[k] * kernel_slope(group, k), x = group.x(k), y = group.y(k);
    xx += w * x * x, xy += w * x * y, yy += w * y * y;
  }
  const Lanes determinant = xx * yy - xy * xy, trace = xx + yy;
  const Bits sound = determinant > least_pivot * trace * trace;
  const Lanes one = fill(1.0), zero{}, inverse = one / (sound ? determinant : one);
  const Lanes a = sound ? inverse * yy : one, b = sound ? inverse * xy : zero,
              c = sound ? inverse * xx : one;
  for (std::size_t k = 0; k < group.slots; ++k) {
    const Lanes w = own * group.volume[k] * kernel_slope(group, k), x = group.x(k), y = group.y(k);
    const std::array<Lanes, 5> of{w * (a * x - b * y), w * (c * y - b * x), w, zero, w};
    for (int e = 0; e < 5; ++e) store_some(group.weight[e] + k * lane_count, of[e], chosen);
  }
}

}  // namespace

double fitted_reach(const OperatorOptions& options) {
  return options.degree > 2 ? std::min(options.reach, boundary_reach) : options.reach;
}

void Stencils::renew(const Cloud& cloud, const OperatorOptions& options) {
  find_neighbors(cloud, options);
  fit(cloud, options);
}

void Stencils::find_neighbors(const Cloud& cloud, const OperatorOptions& options) {
  reach_.resize(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) reach_[i] = options.reach * cloud.spacing[i];
  const double skin = options.neighbors.skin / options.reach;
  images_.of.clear();
  if (options.period > 0) {
    images_.renew(cloud.points(), reach_, cloud.was, options.period);
    lists_.renew(images_.points(), images_.reach, images_.was, options.neighbors, skin);
    arrange(images_.points(), cloud.size());
  } else {
    lists_.renew(cloud.points(), reach_, cloud.was, options.neighbors, skin);
    if (options.body) keep_in_sight(lists_.rows(), cloud, *options.body, options.reach);
    arrange(cloud.points(), cloud.size());
  }
}

void Stencils::fit(const Cloud& cloud, const OperatorOptions& options) {
  for (auto& weight : weight_) weight.renew(index_.size());
  filling_.resize(cloud.size()), nearest_.resize(cloud.size());
  degraded_in_.assign(groups(), 0);
#pragma omp parallel for schedule(dynamic, 16)
  for (std::size_t group = 0; group < groups(); ++group) fit_group(cloud, options, group);
  degraded_ = std::accumulate(degraded_in_.begin(), degraded_in_.end(), std::size_t{0});
}

/// Rows of a group side by side, of the first n points.
void Stencils::arrange(tree::Points points, std::size_t n) {
  const std::size_t count = (n + lane_count - 1) / lane_count;
  length_.resize(n);
  first_.assign(count + 1, 0);
  for (std::size_t i = 0; i < n; ++i) {
    length_[i] = static_cast<std::uint32_t>(lists_.row(i).size());
    std::size_t& longest = first_[i / lane_count + 1];
    longest = std::max<std::size_t>(longest, length_[i]);
  }
  least_length_ = n == 0 ? 0 : *std::min_element(length_.begin(), length_.end());
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  const std::size_t slots = first_.back() * lane_count;
  index_.renew(slots), dx_.renew(slots), dy_.renew(slots);
  const bool images = !images_.of.empty();
  const auto [x, y] = points;
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < count * lane_count; ++i) {
    const std::size_t self = std::min(i, n - 1);
    std::size_t k = slot(i);
    const std::size_t end = first_[i / lane_count + 1] * lane_count;
    if (i < n)
      for (const std::int32_t j : lists_.row(i)) {
        index_[k] = images ? images_.of[j] : j;
        dx_[k] = x[j] - x[i], dy_[k] = y[j] - y[i];
        k += lane_count;
      }
    for (; k < end; k += lane_count) {
      index_[k] = static_cast<std::int32_t>(self);
      dx_[k] = 2 * reach_[self], dy_[k] = 0;
    }
  }
}

void Stencils::fit_group(const Cloud& cloud, const OperatorOptions& options, std::size_t number) {
  const std::size_t n = cloud.size(), from = number * lane_count;
  const std::size_t base = first_[number] * lane_count, slots = first_[number + 1] - first_[number];
  FitGroup group{dx_.data() + base, dy_.data() + base, {}, slots, {}, {}, {}};
  for (int e = 0; e < 5; ++e) group.weight[e] = weight_[e].data() + base;
  const Lanes spacing = own(cloud.spacing, from);
  group.reach = options.reach * spacing;
  group.half_reach.resize(slots), group.volume.resize(slots);
  Lanes filling = spacing * spacing / (group.reach * group.reach), nearest = fill(2.0);
  for (std::size_t k = 0; k < slots; ++k) {
    const Lanes other = gather(cloud.spacing, index_.data() + base + k * lane_count);
    group.half_reach[k] = 0.5 * options.reach * (spacing + other);
    group.volume[k] = other * other / (spacing * spacing);
    const Lanes r = group.half_reach[k];
    const Lanes distance = group.distance(k);
    filling += other * other / (r * r) * wendland(distance / r);
    nearest = smaller(nearest, distance / (0.5 * (spacing + other)));
  }
  LaneSet high = 0, all = first_lanes(n - from);
  const bool sums = options.kind == OperatorKind::pair_sums;
  for (int lane = 0; lane < lane_count && from + lane < n; ++lane) {
    const std::size_t i = from + lane;
    filling_[i] = wendland_norm * filling[lane], nearest_[i] = nearest[lane];
    bool inside = options.degree > 2 && cloud.inside(i) && !sums;
    const double near = boundary_reach * cloud.spacing[i];
    if (inside)
      for_each(i, [&](std::size_t j, std::size_t k) {
        inside = inside && (cloud.inside(j) || dx_[k] * dx_[k] + dy_[k] * dy_[k] > near * near);
      });
    if (inside) high |= 1u << lane;
  }
  const double cut = fitted_reach(options) / options.reach;
  if (sums) return sum_pairs(group, spacing, all);
  LaneSet low = all & ~high;
  if (high) low |= fit_lanes<4>(group, 1, high);
  if (low) low = fit_lanes<2>(group, cut, low);
  if (low) fit_poorly(group, low);
  degraded_in_[number] = static_cast<std::uint32_t>(__builtin_popcount(low));
}

std::vector<char> Stencils::beside_edge(const Cloud& cloud) const {
  std::vector<char> beside(size(), 0);
  for (std::size_t i = 0; i < size(); ++i)
    if (cloud.kind[i] >= ParticleKind::outer)
      for_each(i, [&](std::size_t j, std::size_t) { beside[j] = 1; });
  return beside;
}

}  // namespace vortree::sph
