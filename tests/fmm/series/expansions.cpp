#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

#include "fmm/series/expansion_kernel.hpp"
#include "fmm/series/specification.hpp"
#include "point_sets.hpp"

using namespace vortree;
using fmm::Complex;

namespace {

/// Points in the frame of a cell of side 1 about the origin, and the same said plainly.
template <class Number>
struct Cluster {
  static constexpr int n = fmm::LatticePoints<Number>::n;
  fmm::LatticePoints<Number> points;
  std::vector<Complex> z;
  std::vector<double> gamma;

  /// Inside the cell, or one cell apart from it.
  Cluster(int size, bool inside, test::Uniform& uniform) {
    points.size = size;
    points.vectors = (size + n - 1) / n;
    for (int i = 0; i < n * points.vectors; ++i) {
      double x = uniform() - 0.5, y = uniform() - 0.5;
      if (!inside) {
        (i % 2 == 0 ? x : y) += i % 4 < 2 ? 2.0 : -2.0;
        (i % 2 == 0 ? y : x) *= 4.0;
      }
      points.x[i] = static_cast<Number>(x), points.y[i] = static_cast<Number>(y);
      points.gamma[i] = i < size ? static_cast<Number>(2 * uniform() - 1) : Number{0};
      if (i >= size) continue;
      z.emplace_back(points.x[i], points.y[i]);
      gamma.push_back(points.gamma[i]);
    }
  }
};

/// Random terms, `padded` real parts and as many imaginary ones, and the first of them plainly.
template <class Number>
struct Series {
  int terms, padded;
  std::vector<Number> parts;
  std::vector<Complex> plain;

  Series(int order, test::Uniform& uniform)
      : terms(order),
        padded(static_cast<int>(
            vortree::padded(static_cast<std::size_t>(order), fmm::VectorOf<Number>::count))),
        parts(2 * static_cast<std::size_t>(padded)) {
    for (Number& part : parts) part = static_cast<Number>(2 * uniform() - 1);
    for (int k = 0; k < order; ++k) plain.emplace_back(parts[k], parts[padded + k]);
  }

  /// Largest difference of the two in round-off of `scale` of each term.
  [[nodiscard]] double difference(double scale) const {
    double worst = 0.0;
    for (int k = 0; k < terms; ++k) {
      worst = std::max(worst, std::abs(Complex(parts[k], parts[padded + k]) - plain[k]) / scale);
    }
    return worst / std::numeric_limits<Number>::epsilon();
  }
};

/// Largest of |u + i v - (Im f, Re f)| at the points, in round-off of `scale`, from sums that
/// began at one.
template <class Number, class Field>
double field_error(const Cluster<Number>& at, const Number* u, const Number* v, double scale,
                   Field field) {
  double worst = 0.0;
  for (std::size_t i = 0; i < at.z.size(); ++i) {
    const Complex plain = field(at.z[i]);
    worst = std::max(worst, std::abs(Complex(v[i] - 1.0, u[i] - 1.0) - plain) / scale);
  }
  return worst / std::numeric_limits<Number>::epsilon();
}

constexpr int sizes[] = {1, 3, 8, 9, 16, 17, 40, 64};
constexpr int orders[] = {1, 2, 8, 13, 16, 29, 40};

template <class Number>
void check_to_series() {
  test::Uniform uniform(5);
  constexpr int n = Cluster<Number>::n;
  for (const int size : sizes) {
    for (const int order : orders) {
      CAPTURE(size, order);
      const Cluster<Number> inside(size, true, uniform), outside(size, false, uniform);
      Series<Number> multipole(order, uniform), local(order, uniform);
      fmm::p2m(inside.z, inside.gamma, 0.0, 1.0, multipole.plain);
      fmm::by_rows<n>(inside.points.vectors, [&]<int rows>(int i) {
        fmm::p2m_rows<Number, rows>(inside.points.x + i, inside.points.y + i,
                                    inside.points.gamma + i, multipole.padded,
                                    multipole.parts.data());
      });
      fmm::p2l(outside.z, outside.gamma, 0.0, 1.0, local.plain);
      fmm::by_rows<n>(outside.points.vectors, [&]<int rows>(int i) {
        fmm::p2l_rows<Number, rows>(outside.points.x + i, outside.points.y + i,
                                    outside.points.gamma + i, local.padded, local.parts.data());
      });
      CHECK(multipole.difference(size + 10.0) < 2.0);
      CHECK(local.difference(size + 10.0) < 2.0);
    }
  }
}

template <class Number>
void check_to_points() {
  test::Uniform uniform(6);
  constexpr int n = Cluster<Number>::n;
  for (const int size : sizes) {
    for (const int order : orders) {
      CAPTURE(size, order);
      const Cluster<Number> inside(size, true, uniform), outside(size, false, uniform);
      const Series<Number> series(order, uniform);
      alignas(64) Number u[fmm::points_a_series], v[fmm::points_a_series];
      std::fill_n(u, fmm::points_a_series, Number{1});
      std::fill_n(v, fmm::points_a_series, Number{1});
      fmm::by_rows<n>(inside.points.vectors, [&]<int rows>(int i) {
        fmm::l2p_rows<Number, rows>(series.parts.data(), series.padded, order, inside.points.x + i,
                                    inside.points.y + i, u + i, v + i);
      });
      CHECK(field_error(inside, u, v, 10.0,
                        [&](Complex z) { return fmm::l2p(series.plain, 0.0, 1.0, z); }) < 3.0);
      std::fill_n(u, fmm::points_a_series, Number{1});
      std::fill_n(v, fmm::points_a_series, Number{1});
      fmm::by_rows<n>(outside.points.vectors, [&]<int rows>(int i) {
        fmm::m2p_rows<Number, rows>(series.parts.data(), series.padded, order, outside.points.x + i,
                                    outside.points.y + i, u + i, v + i);
      });
      CHECK(field_error(outside, u, v, 10.0,
                        [&](Complex z) { return fmm::m2p(series.plain, 0.0, 1.0, z); }) < 3.0);
    }
  }
}

/// f at z of sources, to the digits of a long double.
Complex exact_field(const std::vector<Complex>& z, const std::vector<double>& gamma, Complex at) {
  using Long = std::complex<long double>;
  Long f = 0;
  for (std::size_t j = 0; j < z.size(); ++j) {
    f += static_cast<long double>(gamma[j]) / (Long(at) - Long(z[j]));
  }
  return Complex(f);
}

}  // namespace

TEST_CASE("P2M and P2L by lanes equal those said plainly, any number of points") {
  check_to_series<double>();
  check_to_series<float>();
}

TEST_CASE("L2P and M2P by lanes equal those said plainly, any number of points") {
  check_to_points<double>();
  check_to_points<float>();
}

TEST_CASE("plain operators, link by link, end at the sum over the sources") {
  test::Uniform uniform(7);
  constexpr std::size_t order = 80;
  const Cluster<double> sources(30, true, uniform);
  const double h = 0.02;  // a child; its parent is twice as wide
  const Complex child(0.3, -0.1), parent = child + h * Complex(0.5, -0.5);
  std::vector<Complex> z;
  for (const Complex t : sources.z) z.push_back(child + h * t);
  std::vector<Complex> small(order), large(order), far(order), near(order), points(order);
  fmm::p2m(z, sources.gamma, child, h, small);
  fmm::m2m(small, (child - parent) / (2 * h), 0.5, large);
  for (const Complex d : {Complex(2, 0), Complex(-3, 2), Complex(1, -3)}) {
    const Complex centre = parent + 2 * h * d, inner = centre + h * Complex(0.5, 0.5);
    for (auto* series : {&far, &near, &points}) std::ranges::fill(*series, Complex{});
    fmm::m2l(large, d, far);
    fmm::l2l(far, (inner - centre) / (2 * h), 0.5, near);
    fmm::p2l(z, sources.gamma, inner, h, points);
    for (int i = 0; i < 20; ++i) {
      const Complex at = inner + h * Complex(uniform() - 0.5, uniform() - 0.5);
      const Complex exact = exact_field(z, sources.gamma, at);
      const double scale = 30.0 / std::abs(at - child);
      CHECK(std::abs(fmm::l2p(near, inner, h, at) - exact) < 1e-13 * scale);
      CHECK(std::abs(fmm::l2p(points, inner, h, at) - exact) < 1e-13 * scale);
      CHECK(std::abs(fmm::m2p(large, parent, 2 * h, at) - exact) < 1e-13 * scale);
    }
  }
}
