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

/// Within the body what its own motion has; at its wall the mean of both is 0.
void go_on_within(const Problem& p, tree::Points points, std::span<double> psi) {
  const double rate = p.turning ? p.flow.motion.at(p.time).rate : 0;
  std::vector<double> squares;
  for (const Vec2 at : p.wall->middles()) squares.push_back(dot(at, at));
  const double at_wall = mean(squares);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec2 at{points.x[k], points.y[k]};
    if (p.wall->shape().nearest(at).distance < 0) psi[k] = -rate / 2 * (dot(at, at) - at_wall);
  }
}

}  // namespace

std::vector<double> stream_function_at(tree::Points points, const Blobs& blobs, const Problem& p) {
  const Acting all = acting(blobs, p);
  if (!p.wall) return of_stream_and_blobs(points, all, p);
  const WithMiddles both(points, p.wall->middles());
  std::vector<double> psi = of_stream_and_blobs({both.x, both.y}, all, p);
  p.wall->add_stream_function(all.sheet, of_stream_function(p.sums), {both.x, both.y}, psi);
  const double at_wall = mean(std::span(psi).subspan(points.size()));
  psi.resize(points.size());
  for (double& value : psi) value -= at_wall;
  go_on_within(p, points, psi);
  return psi;
}

}  // namespace vortree::vortex
