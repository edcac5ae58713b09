#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "tree/order/points.hpp"

/// Clouds of points to try trees on; every cloud follows from its seed alone.
namespace vortree::test {

struct Cloud {
  std::string name;
  std::vector<double> x, y;
  [[nodiscard]] tree::Points points() const { return {x, y}; }
  void add(double px, double py) {
    x.push_back(px);
    y.push_back(py);
  }
};

class Chance {
 public:
  explicit Chance(std::uint64_t seed) : engine_(seed) {}
  /// Uniform in [0, 1).
  double real() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  /// Uniform in first..last.
  int whole(int first, int last) {
    return first + static_cast<int>(engine_() % static_cast<std::uint64_t>(last - first + 1));
  }
  std::uint64_t bits() { return engine_(); }

 private:
  std::mt19937_64 engine_;
};

inline constexpr int cloud_kinds = 10;

/// One of cloud_kinds clouds of about n points in or near the unit square.
inline Cloud make_cloud(int kind, int n, Chance& chance) {
  static const char* const names[cloud_kinds] = {
      "uniform",      "clusters",   "ring",      "line along x", "line along y",
      "slanted line", "duplicates", "one place", "lattice",      "closing in on a point"};
  Cloud cloud{names[kind], {}, {}};
  const double a = chance.real(), b = chance.real();
  for (int i = 0; i < n; ++i) {
    const double s = chance.real(), t = chance.real(), turn = 2 * std::numbers::pi * t;
    const double r = std::pow(10.0, -14 * s);
    switch (kind) {
      case 0:
        cloud.add(s, t);
        break;
      case 1:
        cloud.add((i % 3) * 0.4 + 1e-3 * s, (i % 5) * 0.2 + 1e-6 * t);
        break;
      case 2:
        cloud.add(0.5 * std::cos(turn), 0.5 * std::sin(turn));
        break;
      case 3:
        cloud.add(s, b);
        break;
      case 4:
        cloud.add(a, t);
        break;
      case 5:
        cloud.add(s, a + 0.3 * s);
        break;
      case 6:
        cloud.add(std::floor(4 * s) / 7, std::floor(4 * t) / 7);
        break;
      case 7:
        cloud.add(a, b);
        break;
      case 8:
        cloud.add(i % 8, i / 8);
        break;
      default:
        cloud.add(0.6 + r * std::cos(turn), 0.4 + r * std::sin(turn));
        break;
    }
  }
  return cloud;
}

/// Any kind of cloud, of up to `most` points (rarely none), anywhere and of any size.
inline Cloud any_cloud(int most, Chance& chance) {
  const int n = chance.whole(0, 20) == 0 ? chance.whole(0, 2) : chance.whole(1, most);
  Cloud cloud = make_cloud(chance.whole(0, cloud_kinds - 1), n, chance);
  const double scale = std::pow(10.0, chance.whole(-6, 6));
  const double away = chance.whole(0, 2) == 0 ? std::pow(10.0, chance.whole(-2, 8)) : 0;
  for (std::size_t i = 0; i < cloud.x.size(); ++i) {
    cloud.x[i] = away + scale * cloud.x[i];
    cloud.y[i] = scale * cloud.y[i] - away;
  }
  return cloud;
}

}  // namespace vortree::test
