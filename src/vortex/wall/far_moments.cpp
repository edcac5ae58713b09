#include "vortex/wall/far_moments.hpp"

#include <algorithm>
#include <cmath>

#include "vortex/wall/panel_kernel.hpp"
#include "vortex/wall/tuning.hpp"

namespace vortree::vortex {
namespace {

constexpr std::size_t terms = far_moments, numbers = 2 * terms;

/// 0, 1, 2, ...
Lanes lane_numbers() {
  double k[lane_count];
  for (int lane = 0; lane < lane_count; ++lane) k[lane] = lane;
  return load(k);
}

/// Of complex numbers.
Vec2 times(Vec2 a, Vec2 b) {
  return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
}
panel::Vectors times(panel::Vectors a, panel::Vectors b) {
  return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
}

}  // namespace

/// Middles and moments in columns, twice around the curve and a vector more.
class FarMoments::Columns {
 public:
  Columns(std::span<const Vec2> middle, std::span<const double> moments)
      : places_(2 * middle.size() + lane_count), values_((numbers + 2) * places_) {
    for (std::size_t p = 0; p < places_; ++p) {
      const std::size_t j = p % middle.size();
      values_[p] = middle[j].x;
      values_[places_ + p] = middle[j].y;
      for (std::size_t k = 0; k < numbers; ++k)
        values_[(k + 2) * places_ + p] = moments[j * numbers + k];
    }
  }

  /// Im sum_k M_k/(z - c)^k, by Horner's rule, of the panels from `place` on.
  Lanes potential(Vec2 z, std::size_t place) const {
    const panel::Vectors d = z - pair(0, place);
    const Lanes inverse = 1.0 / panel::dot(d, d);
    const panel::Vectors u{d.x * inverse, -d.y * inverse};
    panel::Vectors sum = pair(terms, place);
    for (std::size_t k = terms - 1; k > 0; --k) {
      const panel::Vectors higher = times(u, sum), own = pair(k, place);
      sum = {own.x + higher.x, own.y + higher.y};
    }
    return times(u, times(u, sum)).y;
  }

  double of_panel(Vec2 z, std::size_t place) const { return potential(z, place)[0]; }

  double of_panels(Vec2 z, std::size_t first, std::size_t count) const {
    const Lanes number = lane_numbers();
    Lanes some{};
    for (std::size_t k = 0; k < count; k += lane_count) {
      const Lanes all = potential(z, first + k);
      some += number < static_cast<double>(count - k) ? all : Lanes{};
    }
    return sum(some);
  }

 private:
  panel::Vectors pair(std::size_t k, std::size_t place) const {
    const double* at = &values_[2 * k * places_ + place];
    return {load(at), load(at + places_)};
  }

  std::size_t places_;
  std::vector<double> values_;
};

FarMoments::FarMoments(std::span<const Vec2> edge, std::span<const Vec2> middle,
                       std::span<const double> length, std::size_t aside)
    : panels_(middle.size()),
      aside_(aside),
      edge_(edge.begin(), edge.end()),
      middle_(middle.begin(), middle.end()),
      length_(length.begin(), length.end()) {
  for (std::size_t i = 0; i < panels_; ++i)
    reach_.push_back(std::min(gathered_within * length_[i], gathered_of_clear * clear(i)));
}

/// From the middle of a panel to the nearest edge of those that are far from it.
double FarMoments::clear(std::size_t panel) const {
  double least = INFINITY;
  for (std::size_t k = aside_ + 1; k + aside_ < panels_ + 1; ++k) {
    const Vec2 d = edge_[(panel + k) % panels_] - middle_[panel];
    least = std::min(least, dot(d, d));
  }
  return std::sqrt(least);
}

std::vector<double> FarMoments::none() const {
  return std::vector<double>(numbers * panels_);
}

/// ((d + arm)^k + (d - arm)^k)/2 - d^k and ((d + arm)^k - (d - arm)^k)/(2 arm), from k to k + 1: d
/// times itself and arm^2 times the other; d times itself and, with d^k, the first.
void FarMoments::gather(Vec2 at, const ThreePoints& points, double gamma, std::size_t panel,
                        std::span<double> moments) const {
  const Vec2 d = at - middle_[panel], arm2{points.arm_squared.re, points.arm_squared.im};
  Vec2 even{}, odd{1, 0}, power = d;
  double* moment = &moments[panel * numbers];
  for (std::size_t k = 2; k < terms + 2; ++k, moment += 2) {
    const Vec2 next = times(d, even) + times(arm2, odd);
    odd = times(d, odd) + even + power;
    even = next;
    power = times(d, power);
    const double share = -gamma * points.outer / static_cast<double>(k);
    moment[0] += share * even.x;
    moment[1] += share * even.y;
  }
}

void FarMoments::add_slip(std::span<const double> moments, std::span<double> slip) const {
  if (panels_ < 2 * aside_ + 2) return;
  const Columns columns(middle_, moments);
  const auto n = static_cast<std::ptrdiff_t>(panels_);
  // At each edge, of those panels that are far from both of its neighbors; then of one more each.
  std::vector<double> at_edge(panels_ + 1);
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t i = 0; i < n; ++i)
    at_edge[i] = columns.of_panels(edge_[i], i + aside_ + 1, panels_ - 2 * aside_ - 2);
  at_edge[panels_] = at_edge[0];
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const double begin = at_edge[i] + columns.of_panel(edge_[i], i + panels_ - aside_ - 1);
    const double end = at_edge[i + 1] + columns.of_panel(edge_[(i + 1) % n], i + aside_ + 1);
    slip[i] += panel::inverse_two_pi / length_[i] * (end - begin);
  }
}

void FarMoments::add_slip_elsewhere(std::span<const double> moments, std::span<const Vec2> edge,
                                    std::span<const double> length, std::span<double> slip) const {
  const Columns columns(middle_, moments);
  const std::size_t n = edge.size();
  std::vector<double> at_edge;
  for (const Vec2 at : edge) at_edge.push_back(columns.of_panels(at, 0, panels_));
  for (std::size_t i = 0; i < n; ++i)
    slip[i] += panel::inverse_two_pi / length[i] * (at_edge[(i + 1) % n] - at_edge[i]);
}

}  // namespace vortree::vortex
