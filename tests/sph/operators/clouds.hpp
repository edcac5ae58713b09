#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "sph/cloud/cloud.hpp"
#include "sph/operators/derivatives.hpp"
#include "sph/operators/stencils.hpp"
#include "tree/clouds.hpp"

namespace vortree::sph::test {

using vortree::test::Chance;

/// Particles of the unit square, each at random in the middle of its cell, n to a side and four in
/// place right of the middle; their spacings are a tenth at most off those of the cells.
inline Cloud uneven_cloud(int n, std::uint64_t seed, double jitter = 0.25, bool finer = true) {
  Cloud cloud;
  Chance chance(seed);
  const auto any = [&] { return 2 * chance.real() - 1; };
  const auto put = [&](Vec2 at, double s) {
    const Vec2 by{jitter * any(), jitter * any()};
    cloud.add(at + s * by, s * (1 + 0.1 * any()), ParticleKind::fluid);
  };
  const double s = 1.0 / n;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const Vec2 at{(i + 0.5) * s, (j + 0.5) * s};
      if (!finer || 2 * i < n)
        put(at, s);
      else
        for (const Vec2 c : {Vec2{-1, -1}, Vec2{1, -1}, Vec2{-1, 1}, Vec2{1, 1}})
          put(at + s / 4 * c, s / 2);
    }
  return cloud;
}

/// Cells of a lattice of side s, those in the box from low to high.
inline Cloud lattice(Vec2 low, Vec2 high, double s) {
  Cloud cloud;
  const int across = static_cast<int>(std::lround((high.x - low.x) / s)),
            up = static_cast<int>(std::lround((high.y - low.y) / s));
  for (int i = 0; i < across; ++i)
    for (int j = 0; j < up; ++j)
      cloud.add(low + Vec2{(i + 0.5) * s, (j + 0.5) * s}, s, ParticleKind::fluid);
  return cloud;
}

/// A polynomial in the plane, sum c_ab x^a y^b with a + b <= degree, and its derivatives.
class Polynomial {
 public:
  Polynomial(int degree, Chance& chance) : degree_(degree) {
    for (int a = 0; a <= degree; ++a)
      for (int b = 0; a + b <= degree; ++b) c_[a][b] = 2 * chance.real() - 1;
  }

  double operator()(Vec2 at) const { return derivative(0, 0, at); }

  FieldSlopes slopes(Vec2 at) const {
    return {derivative(1, 0, at), derivative(0, 1, at), derivative(2, 0, at), derivative(1, 1, at),
            derivative(0, 2, at)};
  }

 private:
  static double falling(int a, int k) { return k == 0 ? 1 : k == 1 ? a : a * (a - 1.0); }

  double derivative(int kx, int ky, Vec2 at) const {
    double sum = 0;
    for (int a = kx; a <= degree_; ++a)
      for (int b = ky; a + b <= degree_; ++b)
        sum += c_[a][b] * falling(a, kx) * falling(b, ky) * std::pow(at.x, a - kx) *
               std::pow(at.y, b - ky);
    return sum;
  }

  int degree_;
  double c_[5][5] = {};
};

/// The five derivatives of a field at a particle, neighbor by neighbor.
inline std::array<double, 5> summed(const Stencils& stencils, const std::vector<double>& f,
                                    std::size_t i) {
  std::array<double, 5> sum{};
  stencils.for_each(i, [&](std::size_t j, std::size_t slot) {
    for (int e = 0; e < 5; ++e) sum[e] += stencils.weight(e, slot) * (f[j] - f[i]);
  });
  return sum;
}

inline std::array<double, 5> listed(const FieldSlopes& of) {
  return {of.x, of.y, of.xx, of.xy, of.yy};
}

inline std::vector<double> values(const Cloud& cloud, const auto& field) {
  std::vector<double> f(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) f[i] = field(cloud.at(i));
  return f;
}

}  // namespace vortree::sph::test
