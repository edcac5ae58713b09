#include "flow/near_wake.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace vortree::flow {
namespace {

/// Separation is sought from so far off the rear on [degrees]: vorticity near the front is small
/// and says nothing. A turn of its sign that lasts fewer places is a speck.
inline constexpr double front_of_wall = 150;
inline constexpr int lasting_places = 3;
/// Stations of the wake's line, from the wall on: the first and the farthest, in distances of the
/// wall from the centre, each so many times as far as the one before. The bubble's end is
/// interpolated between them.
inline constexpr double first_station = 0.005, farthest_station = 40, between_stations = 1.03;

Vec2 centre_of(std::span<const Vec2> wall) {
  Vec2 sum;
  for (const Vec2 place : wall) sum = sum + place;
  return (1.0 / static_cast<double>(wall.size())) * sum;
}

/// Distance from `from` along `direction` to the wall (from the inside out).
double way_out(std::span<const Vec2> wall, const body::Shape& shape, Vec2 from, Vec2 direction) {
  double farthest = 0;
  for (const Vec2 place : wall) {
    const Vec2 d = place - from;
    farthest = std::max(farthest, std::hypot(d.x, d.y));
  }
  double inside = 0, outside = 2 * farthest;
  for (int k = 0; k < 60; ++k) {
    const double half = 0.5 * (inside + outside);
    (shape.nearest(from + half * direction).distance < 0 ? inside : outside) = half;
  }
  return outside;
}

struct Station {
  double angle, vorticity;  // from the rear [degrees]; attached flow has vorticity < 0
};

/// The wall of one side (+1: left of the stream), from the front to the rear.
std::vector<Station> side_of(std::span<const double> vorticity, std::span<const Vec2> wall,
                             Vec2 stream, double side) {
  const Vec2 rear = unit(stream), left{-rear.y, rear.x}, centre = centre_of(wall);
  std::vector<Station> stations;
  for (std::size_t i = 0; i < wall.size(); ++i) {
    const Vec2 d = wall[i] - centre;
    const double across = side * dot(d, left);
    if (across > 0)
      stations.push_back(
          {std::atan2(across, dot(d, rear)) * 180 / std::numbers::pi, side * vorticity[i]});
  }
  std::ranges::sort(stations, std::greater{}, &Station::angle);
  return stations;
}

/// Where vorticity turns from that of attached flow, < 0, for good.
std::optional<double> separation_on(std::span<const Station> stations) {
  constexpr std::size_t lasting = lasting_places;
  for (std::size_t k = 1; k + lasting <= stations.size(); ++k) {
    const auto [a0, w0] = stations[k - 1];
    const auto [a1, w1] = stations[k];
    const bool lasts = std::ranges::all_of(stations.subspan(k, lasting),
                                           [](const Station& s) { return s.vorticity >= 0; });
    if (a0 < front_of_wall && w0 < 0 && lasts) return a0 + (a1 - a0) * w0 / (w0 - w1);
  }
  return std::nullopt;
}

}  // namespace

WakeLine wake_line(std::span<const Vec2> wall, const body::Shape& shape, Vec2 stream) {
  const Vec2 downstream = unit(stream), centre = centre_of(wall);
  const double out = way_out(wall, shape, centre, downstream);
  WakeLine line{{}, {}, {}, downstream};
  for (double s = first_station * out; s < farthest_station * out; s *= between_stations) {
    const Vec2 at = centre + (out + s) * downstream;
    line.length.push_back(s);
    line.x.push_back(at.x);
    line.y.push_back(at.y);
  }
  return line;
}

double bubble_length(const WakeLine& line, std::span<const double> u, std::span<const double> v) {
  const auto along = [&](std::size_t k) { return dot({u[k], v[k]}, line.direction); };
  for (std::size_t k = 1; k < line.length.size(); ++k) {
    const double before = along(k - 1), after = along(k);
    if (before < 0 && after >= 0)
      return line.length[k - 1] + (line.length[k] - line.length[k - 1]) * before / (before - after);
  }
  return 0;
}

double separation_angle(std::span<const double> wall_vorticity, std::span<const Vec2> wall,
                        Vec2 stream) {
  double sum = 0;
  int found = 0;
  for (double side : {1.0, -1.0})
    if (const auto angle = separation_on(side_of(wall_vorticity, wall, stream, side))) {
      sum += *angle;
      ++found;
    }
  return found ? sum / found : 0;
}

}  // namespace vortree::flow
