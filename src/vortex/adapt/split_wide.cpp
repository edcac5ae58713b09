#include "vortex/adapt/split_wide.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <span>

#include "base/random.hpp"
#include "vortex/adapt/lattice/laying.hpp"
#include "vortex/adapt/tuning.hpp"
#include "vortex/cores/folded_core.hpp"
#include "vortex/tuning.hpp"

namespace vortree::vortex {
namespace {

/// About six digits: mirror images that differ by round-off still turn alike.
std::uint64_t rounded(double a) {
  return (std::bit_cast<std::uint64_t>(a) + (1ull << 31)) >> 32;
}

Vec2 direction(double phi) {
  return {std::cos(phi), std::sin(phi)};
}

/// Rings of children, of radius 1.
class Rings {
 public:
  Rings(const Splitting& splitting, std::uint64_t step)
      : hash_(splitmix64(splitting.seed ^ splitmix64(step))) {
    const double sector = 2 * std::numbers::pi / splitting.children;
    for (int c = 0; c < splitting.children; ++c) child_.push_back(direction(sector * c));
    for (std::size_t k = 0; k < turn_.size(); ++k)
      turn_[k] = direction(sector * static_cast<double>(k) / turn_.size());
  }

  /// How far the ring of a blob is turned, as a unit vector.
  Vec2 turn(double gamma, double sigma) const {
    const std::uint64_t hash =
        splitmix64(hash_ ^ rounded(std::abs(gamma)) ^ (rounded(sigma) << 32));
    const Vec2 turned = turn_[hash % turn_.size()];
    return {turned.x, std::copysign(turned.y, gamma)};
  }

  Vec2 child(Vec2 turned, int c) const {
    const Vec2 at = child_[c];
    return {turned.x * at.x - turned.y * at.y, turned.y * at.x + turned.x * at.y};
  }

 private:
  std::uint64_t hash_;
  std::vector<Vec2> child_;
  std::array<Vec2, 1024> turn_;
};

/// A strained core's deviator, parted: what shows in where its children lie, and what they keep.
struct Parted {
  Deviator shown, kept;

  /// Children lie at variance b in either direction, within `most` of it, and are never thinner, in
  /// units of their width, than their parent; nor flat.
  Parted(const Core& parent, double alpha2) {
    constexpr double most = 0.9, flattest = 0.98;
    const double b = parent.square * (1 - alpha2) / 2, child = parent.square * alpha2 / 2;
    const double size = parent.deviator.size();
    const double spread = std::min({size, std::max(most * b, (1 - alpha2) * size), flattest * b});
    if (size == 0) return;
    shown = (spread / size) * parent.deviator;
    kept = (std::min(size - spread, flattest * child) / size) * parent.deviator;
  }
};

/// The square root of the covariance b I + D.
struct Root {
  double xx, xy, yy;

  Root(double b, Deviator d) {
    const double det = std::sqrt(std::max(b * b - d.xx * d.xx - d.xy * d.xy, 0.0)),
                 trace = std::sqrt(2 * (b + det));
    xx = (b + d.xx + det) / trace;
    xy = d.xy / trace;
    yy = (b - d.xx + det) / trace;
  }
  Vec2 operator()(Vec2 a) const { return {xx * a.x + xy * a.y, xy * a.x + yy * a.y}; }
};

/// The children of a free blob.
void split_freely(std::span<AdaptedBlob> children, const AdaptedBlob& parent, double alpha2,
                  const Rings& rings) {
  const double b = parent.square * (1 - alpha2) / 2;
  const Parted deviator(parent.core(), alpha2);
  const Root root(b, deviator.shown);
  const Vec2 turned = std::numbers::sqrt2 * rings.turn(parent.gamma, std::sqrt(parent.square));
  for (std::size_t c = 0; c < children.size(); ++c) {
    const Vec2 at = parent.centre() + root(rings.child(turned, static_cast<int>(c)));
    children[c] = parent;
    children[c].x = at.x;
    children[c].y = at.y;
    children[c].gamma /= static_cast<double>(children.size());
    children[c].square *= alpha2;
    children[c].deviator = deviator.kept;
  }
}

/// A cross of children beside a flat wall, in units of their width: two at the parent's distance,
/// shifted, two farther and nearer by `arm`. share: of the first two.
struct Cross {
  double share, shift, arm;
};

/// Mean distance of a core of width 1 at a distance q from a flat wall, and its derivative.
struct Mean {
  double value, slope;

  explicit Mean(double q) : value(std::abs(q)), slope(std::copysign(1.0, q)) {
    if (value >= folded::support) return;
    const folded::Profile p = folded::profile(q);
    value = p.mean;
    slope = p.erf;
  }
};

/// The cross with the parent's mean distance from the wall and mean square of it: of all there are,
/// the one nearest to the usual share without a shift.
///
/// q      distance of the parent, in widths of its children
/// wider  parent's width across the wall, in widths of its children
Cross cross(double q, double wider) {
  const double b = (wider * wider - 1) / 2, mean = wider * Mean(q / wider).value;
  // Far narrower children than 0.55 of the parent may have no such cross; theirs stays one.
  const double most_outward = std::sqrt(q * q + 0.9 * b) - q, most_inward = 0.5 * std::sqrt(b);
  Cross c{usual_share, 0, 0};
  for (int k = 0; k < 12; ++k) {
    const double rest = 1 - c.share, at = q + c.shift;
    c.arm = std::sqrt((b - (q + at) * c.shift) / rest);
    const Mean mid(at), out(at + c.arm), in(at - c.arm);
    const double pair = (out.value + in.value) / 2;
    const double missed = c.share * mid.value + rest * pair - mean;
    if (std::abs(missed) < 1e-14 * mean) break;
    const double by_arm = rest * (out.slope - in.slope) / 2;
    const double by_shift =
        c.share * mid.slope + rest * (out.slope + in.slope) / 2 - by_arm * at / (rest * c.arm);
    const double by_share = mid.value - pair + by_arm * c.arm / (2 * rest);
    const double step = missed / (by_shift * by_shift + by_share * by_share);
    c.shift = std::clamp(c.shift - step * by_shift, -most_inward, most_outward);
    c.share = std::clamp(c.share - step * by_share, 0.3, 0.9);
  }
  return c;
}

/// Moves and widens what children are to act as, so that folded centroid, mean and variance of the
/// distance from the wall are those of their parent.
void keep_moments(std::span<const AdaptedBlob> children, std::span<AtWall> at_wall,
                  const std::array<double, 4>& share, Vec2 centroid, const AtWall& parent) {
  Vec2 acts;
  double mean = 0, square = 0;
  for (int k = 0; k < 4; ++k) {
    const AtWall& own = at_wall[k];
    acts += share[k] * (children[k].centre() + own.offset);
    mean += share[k] * own.mean;
    square += share[k] * (own.across + own.mean * own.mean);
  }
  for (AtWall& own : at_wall) {
    own.offset += centroid - acts;
    own.mean += parent.mean - mean;
    own.across += parent.across - (square - mean * mean);
    own.moved = true;
  }
}

/// The children of a blob that the wall folds: a cross along and across it, sheared by the
/// parent's tilt, which follows the wall's bend. All are to act so far from where they would, and
/// so much wider, that mean and variance stay.
void split_at_wall(std::span<AdaptedBlob> children, std::span<AtWall> at_wall,
                   const AdaptedBlob& parent, double alpha2, const body::Shape& wall,
                   const body::WallPoint& w) {
  const double child2 = alpha2 * parent.square, child = std::sqrt(child2);
  const Parted deviator(parent.core(), alpha2);
  const Covariance v = Core{parent.square, deviator.shown}.covariance(w.normal);
  const double y = height(w, parent.core().covariance(w.normal));
  const Cross c = cross(y / child, std::sqrt(2 * v.nn) / child);
  const double at = y + child * c.shift, arm = child * c.arm;
  const std::array<double, 4> distance{at, at, at + arm, std::abs(at - arm)};
  const std::array<double, 4> share{c.share / 2, c.share / 2, (1 - c.share) / 2, (1 - c.share) / 2};
  std::array<double, 4> acts;
  double mean = 0, square = 0;
  for (int k = 0; k < 4; ++k) {
    acts[k] = child * Mean(distance[k] / child).value;
    mean += share[k] * acts[k];
    square += share[k] * acts[k] * acts[k];
  }
  // What of the tilt their distances have room for, and, along the wall, their shares.
  const double across = square - mean * mean, behind = v.tt - child2 / 2;
  const double most = 0.9 * std::sqrt(across * behind);
  const double tilt = std::clamp(v.nt, -most, most), lean = tilt / across;
  // Mirror images of parents have mirror images of children, in their order.
  const double along = std::copysign(std::sqrt((behind - lean * tilt) / c.share), parent.gamma);
  const std::array<double, 4> aside{along, -along, 0, 0};
  Covariance own = Core{child2, deviator.kept}.covariance(w.normal);
  own.nt = std::clamp(own.nt + v.nt - tilt, -0.9 * std::sqrt(own.nn * own.tt),
                      0.9 * std::sqrt(own.nn * own.tt));
  const Core rest = core_of(own, w.normal);
  const Vec2 foot = parent.centre() - w.distance * w.normal;
  for (int k = 0; k < 4; ++k) {
    const double t = aside[k] + lean * (acts[k] - mean);
    const double bent = folded::sag(own.nn, own.tt + t * t, w.curvature);
    const Vec2 place = foot + (distance[k] - bent) * w.normal + t * w.tangent();
    children[k] = {place.x,         place.y,        share[k] * parent.gamma,
                   rest.square,     rest.deviator,  parent.at_wall + k,
                   parent.widening, parent.leniency};
    at_wall[k] = beside(wall.nearest(place), rest);
  }
  const AtWall as_one = beside(w, parent.core());
  keep_moments(children, at_wall, share, parent.centre() + as_one.offset, as_one);
}

constexpr int children_at_wall = 4;

/// Where the children of each blob begin, and what they know of the wall. Those that are laid onto
/// a lattice have none.
struct Places {
  std::vector<std::uint32_t> children, at_wall;
  std::vector<float> widening, leniency;
  std::vector<std::int8_t> laid;  // onto this level
  WallPoints nearest;
  std::size_t count_laid = 0, count_split = 0;

  Places(const Blobs& blobs, double widest, const Splitting& splitting, const body::Shape* wall,
         const Laying& laying, const WallPoints& found)
      : children(blobs.size() + 1),
        at_wall(blobs.size() + 1),
        widening(blobs.size()),
        leniency(blobs.size()),
        laid(blobs.size()),
        nearest(blobs.size()) {
    const auto n = static_cast<std::ptrdiff_t>(blobs.size());
    const double alpha = splitting.alpha;
    const bool coarsens = wall && !splitting.coarsening.everywhere_alike();
    // A child of those beyond is no nearer than it reaches.
    const double support_of_split =
        std::max(folded::support, folded::support * alpha + 1.5 * std::sqrt(1 - alpha * alpha));
#pragma omp parallel for schedule(dynamic, blobs_a_turn)
    for (std::ptrdiff_t i = 0; i < n; ++i) {
      const double s = vortex::widest(blobs.core(i));
      const double seen = std::max(support_of_split * s, laying.seen_from(s));
      const body::WallPoint w = found.nearest(i, blobs.centre(i), seen, wall);
      nearest.keep(i, w);
      const bool far = coarsens && w.distance == INFINITY;
      const double distance = far ? wall->distance(blobs.centre(i)) : w.distance;
      const float of_place = coarsens ? splitting.coarsening.widening(distance) : 1.0f;
      const bool splits = blobs.sigma[i] > widest * of_place;
      const bool folds = distance < (splits ? support_of_split : folded::support) * s;
      Laying::Lot lot = laying.lot(blobs, i, w, distance, of_place);
      if (folds && lot.level != Laying::along_wall)
        lot = {.widening = of_place, .leniency = of_place};
      widening[i] = lot.widening;
      leniency[i] = lot.leniency;
      laid[i] = lot.level;
      const int split = folds ? children_at_wall : splitting.children;
      children[i + 1] = lot.level != Laying::none ? 0 : splits && !lot.free ? split : 1;
      at_wall[i + 1] = folds ? children[i + 1] : 0;
    }
    for (std::ptrdiff_t i = 0; i < n; ++i) {
      count_laid += children[i + 1] == 0;
      count_split += children[i + 1] > 1;
      children[i + 1] += children[i];
      at_wall[i + 1] += at_wall[i];
    }
  }

  std::size_t children_of(std::size_t i) const {
    return children[i + 1] - children[i];
  }
  bool beside_wall(std::size_t i) const {
    return at_wall[i + 1] > at_wall[i];
  }
};

}  // namespace

AdaptedBlobs split_apart(const Blobs& blobs, const Splitting& splitting, const body::Shape* wall,
                         std::uint64_t step, const WallPoints& found) {
  const auto n = static_cast<std::ptrdiff_t>(blobs.size());
  const double widest = splitting.sigma_max * (1 + 1e-12),
               alpha2 = splitting.alpha * splitting.alpha;
  const Laying laying(splitting, wall, step);
  const Places places(blobs, widest, splitting, wall, laying, found);
  const Rings rings(splitting, step);
  AdaptedBlobs adapted;
  adapted.all.resize(places.children[n]);
  adapted.at_wall.resize(places.at_wall[n]);
  adapted.laid = places.count_laid;
  adapted.split = places.count_split;
#pragma omp parallel for schedule(dynamic, blobs_a_turn)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const Vec2 at = blobs.centre(i);
    const Core core = blobs.core(i);
    const bool near = places.beside_wall(i);
    const std::uint32_t slot = near ? places.at_wall[i] : no_wall;
    const std::span<AdaptedBlob> made =
        std::span(adapted.all).subspan(places.children[i], places.children_of(i));
    const AdaptedBlob parent{at.x,          at.y, blobs.gamma[i],     core.square,
                             core.deviator, slot, places.widening[i], places.leniency[i]};
    const body::WallPoint nearest = places.nearest.known(i);
    if (made.size() == 1) {
      made[0] = parent;
      if (near) adapted.at_wall[slot] = beside(nearest, core);
    } else if (near) {
      split_at_wall(made, {&adapted.at_wall[slot], made.size()}, parent, alpha2, *wall, nearest);
    } else {
      split_freely(made, parent, alpha2, rings);
    }
  }
  laying.append_nodes(adapted, blobs, places.laid, places.nearest);
  return adapted;
}

void split_wide(Blobs& blobs, const Splitting& splitting, const body::Shape* wall,
                std::uint64_t step) {
  blobs = pack(split_apart(blobs, splitting, wall, step), wall);
}

}  // namespace vortree::vortex
