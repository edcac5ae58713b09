#include "body/course.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace vortree::body {
namespace {

constexpr int stencil = 9;

/// Weights of the first and the second derivative at 0 for values at some places.
/// source  Fornberg, Math. Comp. 51 (1988), the recursion for weights of any order
struct DifferenceWeights {
  std::array<double, stencil> first{}, second{};

  explicit DifferenceWeights(const std::array<double, stencil>& place) {
    std::array<std::array<double, 3>, stencil> w{};
    w[0][0] = 1;
    double last = 1;
    for (int n = 1; n < stencil; ++n) {
      double product = 1;
      for (int k = 0; k < n; ++k) {
        const double apart = place[n] - place[k];
        product *= apart;
        if (k == n - 1)
          for (int d = 2; d >= 0; --d)
            w[n][d] = last / product * ((d ? d * w[k][d - 1] : 0) - place[k] * w[k][d]);
        for (int d = 2; d >= 0; --d)
          w[k][d] = (place[n] * w[k][d] - (d ? d * w[k][d - 1] : 0)) / apart;
      }
      last = product;
    }
    for (int k = 0; k < stencil; ++k) first[k] = w[k][1], second[k] = w[k][2];
  }
};

/// Of the nine values from `begin` on, seen from place `at` of them.
DifferenceWeights seen_from(int at) {
  std::array<double, stencil> place;
  for (int k = 0; k < stencil; ++k) place[k] = k - at;
  return DifferenceWeights(place);
}

/// Solves a system of three diagonals; what it overwrites is of no more use.
std::vector<double> solve(std::vector<double> below, std::vector<double> on,
                          std::vector<double> above, std::vector<double> right) {
  const std::size_t n = on.size();
  for (std::size_t i = 1; i < n; ++i) {
    const double share = below[i] / on[i - 1];
    on[i] -= share * above[i - 1];
    right[i] -= share * right[i - 1];
  }
  for (std::size_t i = n; i-- > 0;)
    right[i] = (right[i] - (i + 1 < n ? above[i] * right[i + 1] : 0)) / on[i];
  return right;
}

/// The second derivatives of the spline. Beside an end a cubic goes on through the second time, so
/// that the first is on the line of the next two: m_0 = m_1 + (m_1 - m_2) h_0/h_1.
std::vector<double> bends(std::span<const double> t, std::span<const double> f) {
  const std::size_t n = t.size() - 2;
  std::vector<double> below(n), on(n), above(n), right(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double before = t[i + 1] - t[i], after = t[i + 2] - t[i + 1];
    below[i] = before, on[i] = 2 * (before + after), above[i] = after;
    right[i] = 6 * ((f[i + 2] - f[i + 1]) / after - (f[i + 1] - f[i]) / before);
  }
  const double first = below[0] / above[0], last = above[n - 1] / below[n - 1];
  on[0] += below[0] * (1 + first), above[0] -= below[0] * first;
  on[n - 1] += above[n - 1] * (1 + last), below[n - 1] -= above[n - 1] * last;
  std::vector<double> m = solve(below, on, above, right);
  m.insert(m.begin(), m[0] + (m[0] - m[1]) * first);
  m.push_back(m[n] + (m[n] - m[n - 1]) * last);
  return m;
}

/// A polynomial of degree five on 0 .. 1, by its value and two derivatives at both ends.
struct Quintic {
  std::array<double, 6> c;

  Quintic(const Jets& of, std::size_t i, double h) {
    const double f0 = of.value[i], d0 = h * of.first[i], s0 = h * h * of.second[i] / 2;
    const double f1 = of.value[i + 1], d1 = h * of.first[i + 1], s1 = h * h * of.second[i + 1] / 2;
    const double a = f1 - f0 - d0 - s0, b = d1 - d0 - 2 * s0, e = s1 - s0;
    c = {f0, d0, s0, 10 * a - 4 * b + e, -15 * a + 7 * b - 2 * e, 6 * a - 3 * b + e};
  }

  std::array<double, 3> at(double s) const {
    double f = 0, d = 0, half = 0;
    for (int k = 5; k >= 0; --k) {
      half = half * s + d;
      d = d * s + f;
      f = f * s + c[k];
    }
    return {f, d, 2 * half};
  }
};

}  // namespace

Course::Course(std::vector<double> times, std::array<Jets, 3> of, Vec2 about)
    : times_(std::move(times)),
      of_(std::move(of)),
      about_(about),
      turns_(std::ranges::any_of(of_[2].value, [](double angle) { return angle != 0; })) {}

Kinematics Course::at(double t) const {
  if (!moves()) return {};
  const std::size_t after = std::ranges::upper_bound(times_, t) - times_.begin();
  const std::size_t i = std::clamp<std::size_t>(after, 1, times_.size() - 1) - 1;
  const double h = times_[i + 1] - times_[i];
  std::array<std::array<double, 3>, 3> now;
  for (int k = 0; k < 3; ++k) now[k] = Quintic(of_[k], i, h).at((t - times_[i]) / h);
  for (auto& [value, first, second] : now) first /= h, second /= h * h;
  const auto& [angle, rate, spin_up] = now[2];
  const Vec2 arm = Turn(angle)(about_);
  return {Vec2{now[0][0], now[1][0]} + about_ - arm,
          Vec2{now[0][1], now[1][1]} - rate * left_of(arm),
          Vec2{now[0][2], now[1][2]} - spin_up * left_of(arm) + rate * rate * arm,
          angle,
          rate,
          spin_up};
}

Jets known_evenly(std::vector<double> values, double step) {
  Jets jets{std::move(values), {}, {}};
  const int n = static_cast<int>(jets.value.size());
  std::vector<DifferenceWeights> seen;
  for (int at = 0; at < stencil; ++at) seen.push_back(seen_from(at));
  for (int i = 0; i < n; ++i) {
    const int begin = std::clamp(i - stencil / 2, 0, n - stencil);
    const DifferenceWeights& weights = seen[i - begin];
    double first = 0, second = 0;
    for (int k = 0; k < stencil; ++k) {
      // Less the value itself: what stands still has derivatives of 0.
      const double f = jets.value[begin + k] - jets.value[i];
      first += weights.first[k] * f, second += weights.second[k] * f;
    }
    jets.first.push_back(first / step), jets.second.push_back(second / (step * step));
  }
  return jets;
}

Jets spline_through(std::span<const double> t, std::vector<double> values) {
  Jets jets{std::move(values), {}, {}};
  jets.second = bends(t, jets.value);
  const std::size_t last = t.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    const std::size_t k = std::min(i, last - 1);
    const double h = t[k + 1] - t[k], slope = (jets.value[k + 1] - jets.value[k]) / h;
    const double near = jets.second[k], far = jets.second[k + 1];
    jets.first.push_back(i == k ? slope - h * (2 * near + far) / 6
                                : slope + h * (near + 2 * far) / 6);
  }
  return jets;
}

}  // namespace vortree::body
