#include "vortex/stream_function.hpp"

#include <algorithm>
#include <numeric>

#include "fmm/plan.hpp"
#include "vortex/tuning.hpp"

namespace vortree::vortex {
namespace {

fmm::Options of_stream_function(fmm::Options sums) {
  sums.cores = fmm::Cores::source;
  sums.tolerance = std::min(sums.tolerance, stream_function_tolerance);
  return sums;
}

std::vector<double> of_stream_and_blobs(tree::Points points, const Acting& all, const Problem& p) {
  std::vector<double> psi(points.size());
  fmm::Plan({all.x, all.y, all.gamma, all.sigma}, of_stream_function(p.sums))
      .stream_function(fmm::Targets{points.x, points.y, {}}, psi);
  const Vec2 stream = p.flow.stream_at(p.time);
  for (std::size_t k = 0; k < psi.size(); ++k)
    psi[k] += stream.x * points.y[k] - stream.y * points.x[k];
  return psi;
}

/// Points, and the middles of panels after them.
struct WithMiddles {
  std::vector<double> x, y;

  WithMiddles(tree::Points points, std::span<const Vec2> middles)
      : x(points.x.begin(), points.x.end()), y(points.y.begin(), points.y.end()) {
    for (const Vec2 at : middles) x.push_back(at.x), y.push_back(at.y);
  }
};

double mean(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Within a body what its own motion has; at its wall the mean of both is `at_wall`.
void go_on_within(const Problem& p, std::size_t body, double at_wall, tree::Points points,
                  std::span<double> psi) {
  const double rate = p.flow.rate(body, p.time);
  const Vec2 velocity = p.flow.own_at(body, p.time).velocity;
  const Ring& ring = p.wall->rings()[body];
  const auto own = [&](Vec2 at) {
    const Vec2 arm = at - ring.centre;
    return velocity.x * arm.y - velocity.y * arm.x - rate / 2 * dot(arm, arm);
  };
  std::vector<double> along_wall;
  for (std::size_t i = ring.first; i < ring.end(); ++i)
    along_wall.push_back(own(p.wall->middle(i)));
  const double own_at_wall = mean(along_wall);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec2 at{points.x[k], points.y[k]};
    const body::WallPoint w = p.wall->shape().nearest(at);
    if (w.distance < 0 && p.wall->ring_at(w.arc) == body) psi[k] = at_wall + own(at) - own_at_wall;
  }
}

}  // namespace

std::vector<double> stream_function_at(tree::Points points, const Blobs& blobs, const Problem& p) {
  const Acting all = acting(blobs, p);
  if (!p.wall) return of_stream_and_blobs(points, all, p);
  const WithMiddles both(points, p.wall->middles());
  std::vector<double> psi = of_stream_and_blobs({both.x, both.y}, all, p);
  p.wall->add_stream_function(all.sheet, of_stream_function(p.sums), {both.x, both.y}, psi);
  const std::vector<double> at_walls(psi.begin() + points.size(), psi.end());
  psi.resize(points.size());
  const double first = mean(p.wall->rings()[0].of(at_walls));
  for (double& value : psi) value -= first;
  for (std::size_t k = 0; k < p.wall->rings().size(); ++k)
    go_on_within(p, k, mean(p.wall->rings()[k].of(at_walls)) - first, points, psi);
  return psi;
}

}  // namespace vortree::vortex
