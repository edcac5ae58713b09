#include "vortex/blobs/drifting.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "vortex/tuning.hpp"

namespace vortree::vortex {
namespace {

/// Takes away all vortices but those that `stays(i)` names.
void keep(Drifting& drifting, auto stays) {
  Drifting kept;
  for (std::size_t i = 0; i < drifting.size(); ++i)
    if (stays(i))
      kept.append(drifting.at(i), drifting.gamma[i], drifting.sigma[i], drifting.spread[i]);
  drifting = std::move(kept);
}

/// How many times as far as the box, which holds the origin, something is.
double times_as_far(Vec2 at, const Box& box) {
  at = box.axes(at);
  return std::max({at.x / box.high.x, at.x / box.low.x, at.y / box.high.y, at.y / box.low.y});
}

/// One vortex of two.
struct Merger {
  Vec2 at;
  double gamma, square, spread;

  Merger(const Drifting& d, std::size_t a, std::size_t b) : gamma(d.gamma[a] + d.gamma[b]) {
    const double of_a = d.gamma[a] / gamma, of_b = d.gamma[b] / gamma;
    const Vec2 way = d.at(b) - d.at(a);
    const double apart = of_a * of_b * dot(way, way);
    at = d.at(a) + of_b * way;
    square = of_a * d.sigma[a] * d.sigma[a] + of_b * d.sigma[b] * d.sigma[b] + apart;
    spread = of_a * d.spread[a] + of_b * d.spread[b] + apart;
  }

  /// What of it a body feels, within so much of the origin [m/s].
  double felt(double radius) const {
    const double far = std::max(std::sqrt(dot(at, at)) - radius, radius / 10);
    return std::abs(gamma) * spread / (2 * std::numbers::pi * far * far * far);
  }
};

/// With which of the first `i` vortices to merge vortex i: where least is felt of it.
std::optional<std::size_t> partner(const Drifting& d, std::size_t i, double radius, double most) {
  std::optional<std::size_t> best;
  for (std::size_t k = 0; k < i; ++k) {
    if ((d.gamma[k] > 0) != (d.gamma[i] > 0)) continue;
    const double felt = Merger(d, k, i).felt(radius);
    if (felt > most) continue;
    most = felt;
    best = k;
  }
  return best;
}

void put(Drifting& d, std::size_t i, const Merger& merged) {
  d.x[i] = merged.at.x;
  d.y[i] = merged.at.y;
  d.gamma[i] = merged.gamma;
  d.sigma[i] = std::sqrt(merged.square);
  d.spread[i] = merged.spread;
}

/// Each in its turn merges into one that came before.
void merge_once(Drifting& drifting, double radius, double unfelt) {
  Drifting left;
  for (std::size_t i = 0; i < drifting.size(); ++i) {
    left.append(drifting.at(i), drifting.gamma[i], drifting.sigma[i], drifting.spread[i]);
    const std::size_t last = left.size() - 1;
    const auto k = partner(left, last, radius, unfelt);
    if (!k) continue;
    put(left, *k, Merger(left, *k, last));
    left.drop_last();
  }
  drifting = std::move(left);
}

}  // namespace

void Drifting::append(Vec2 place, double circulation, double core, double wide) {
  x.push_back(place.x);
  y.push_back(place.y);
  gamma.push_back(circulation);
  sigma.push_back(core);
  spread.push_back(wide);
}

void Drifting::drop_last() {
  for (auto* column : {&x, &y, &gamma, &sigma, &spread}) column->pop_back();
}

void take(Drifting& drifting, const Blobs& left) {
  for (std::size_t i = 0; i < left.size(); ++i)
    if (left.gamma[i] != 0) drifting.append(left.centre(i), left.gamma[i], left.sigma[i], 0);
}

void drift(Drifting& drifting, Vec2 way, double spread, const Box& box, const Turn& turn) {
  for (std::size_t i = 0; i < drifting.size(); ++i) {
    const Vec2 to = turn(drifting.at(i)) + way;
    drifting.x[i] = to.x;
    drifting.y[i] = to.y;
    drifting.sigma[i] = std::sqrt(drifting.sigma[i] * drifting.sigma[i] + spread);
  }
  keep(drifting, [&](std::size_t i) { return felt_share(drifting.at(i), box) > 0; });
}

Blobs come_back(Drifting& drifting, const Box& box) {
  Blobs back;
  for (std::size_t i = 0; i < drifting.size(); ++i)
    if (box.holds(drifting.at(i)))
      back.append(drifting.at(i), drifting.gamma[i], drifting.sigma[i]);
  if (back.size() > 0) keep(drifting, [&](std::size_t i) { return !box.holds(drifting.at(i)); });
  return back;
}

double felt_share(Vec2 at, const Box& box) {
  const double left = felt_until - times_as_far(at, box);
  return std::clamp(left / (felt_until - whole_until), 0.0, 1.0);
}

Blobs felt(const Drifting& drifting, const Box& box) {
  Blobs blobs;
  for (std::size_t i = 0; i < drifting.size(); ++i) {
    const Vec2 at = drifting.at(i);
    blobs.append(at, felt_share(at, box) * drifting.gamma[i], drifting.sigma[i]);
  }
  return blobs;
}

void merge_drifting(Drifting& drifting, double radius, double unfelt) {
  merge_once(drifting, radius, unfelt);
  while (drifting.size() > most_drifting) merge_once(drifting, radius, unfelt *= 2);
}

}  // namespace vortree::vortex
