#include "base/rate_of_change.hpp"

#include <cmath>
#include <numeric>

namespace vortree {
namespace {

/// Weights that give the slope, at s = 0, of the parabola that fits values at s best: by the
/// polynomials s - mean and s^2 - b s - c, which are orthogonal over s to each other and to 1.
std::vector<double> slope_of_best_parabola(std::span<const double> s) {
  const std::size_t n = s.size();
  const double mean = std::reduce(s.begin(), s.end()) / static_cast<double>(n);
  std::vector<double> line(n), parabola(n);
  double lines = 0, parabolas = 0, b = 0, c = 0;
  for (std::size_t i = 0; i < n; ++i) {
    line[i] = s[i] - mean;
    lines += line[i] * line[i];
  }
  for (std::size_t i = 0; i < n; ++i) b += s[i] * s[i] * line[i] / lines;
  for (std::size_t i = 0; i < n; ++i) c += s[i] * (s[i] - b) / static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i) {
    parabola[i] = s[i] * (s[i] - b) - c;
    parabolas += parabola[i] * parabola[i];
  }
  std::vector<double> weights(n);
  for (std::size_t i = 0; i < n; ++i) weights[i] = line[i] / lines - b * parabola[i] / parabolas;
  return weights;
}

}  // namespace

RateOfChange RateOfChange::in_the_middle(double t0, double t1, double t2) {
  const double s0 = std::sqrt(t0), s1 = std::sqrt(t1), s2 = std::sqrt(t2);
  return {{(s1 - s2) / ((s0 - s1) * (s0 - s2)) / (2 * s1), 0,
           (s1 - s0) / ((s2 - s0) * (s2 - s1)) / (2 * s1)},
          1};
}

RateOfChange RateOfChange::at_the_end(std::span<const double> t, bool impulsive) {
  const double last = std::sqrt(t.back());
  if (t.size() == 2) {
    const double over = impulsive ? 2 * last * (last - std::sqrt(t[0])) : t[1] - t[0];
    return {{-1 / over, 0}, 1};
  }
  std::vector<double> s;
  for (const double time : t) s.push_back(std::sqrt(time) - last);
  std::vector<double> weights = slope_of_best_parabola(s);
  for (double& weight : weights) weight /= 2 * last;
  return {std::move(weights), t.size() - 1};
}

Vec2 RateOfChange::operator()(std::span<const Vec2> values) const {
  Vec2 sum;
  for (std::size_t i = 0; i < values.size(); ++i) sum += of_[i] * (values[i] - values[at_]);
  return sum;
}

}  // namespace vortree
