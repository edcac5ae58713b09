#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <vector>

#include "fmm/cores/core_kernel.hpp"
#include "fmm/near/p2p_kernel.hpp"
#include "fmm/near/p2p_single_kernel.hpp"
#include "fmm/reference.hpp"
#include "fmm/series/multipole_kernel.hpp"
#include "fmm/series/multipole_single_kernel.hpp"
#include "fmm/series/specification.hpp"
#include "point_sets.hpp"

using namespace vortree;
using fmm::Complex;

namespace {

template <class Exp>
double core_once(double q) {
  const Lanes argument[1] = {fill(q)};
  Lanes result[1];
  fmm::core<Exp>(argument, result);
  return result[0][lane_count - 1];
}

template <class Exp>
double worst_core_error() {
  double worst = 0.0;
  for (double q = 1e-300; q<1e300; q *= q> 1e-20 && q < 1000 ? 1.0003 : 1.7) {
    const long double exact = -std::expm1(-static_cast<long double>(q));
    worst = std::max(worst, std::abs(static_cast<double>(core_once<Exp>(q) / exact - 1)));
  }
  return worst;
}

/// Sources in a unit disk about `centre`, scaled by h.
struct Cluster {
  std::vector<Complex> z;
  std::vector<double> x, y, gamma;

  Cluster(std::size_t n, Complex centre, double h) {
    test::Uniform uniform(n);
    while (z.size() < n) {
      const double a = 2 * uniform() - 1, b = 2 * uniform() - 1;
      if (a * a + b * b > 1) continue;
      z.push_back(centre + h * Complex(a, b));
      x.push_back(z.back().real()), y.push_back(z.back().imag());
      gamma.push_back(2 * uniform() - 1);
    }
  }

  [[nodiscard]] std::vector<Complex> multipole(Complex centre, double h, int order) const {
    std::vector<Complex> terms(static_cast<std::size_t>(order));
    fmm::p2m(z, gamma, centre, h, terms);
    return terms;
  }

  [[nodiscard]] std::complex<long double> field(Complex at) const {
    std::complex<long double> f = 0;
    for (std::size_t j = 0; j < z.size(); ++j) {
      f += static_cast<long double>(gamma[j]) /
           (std::complex<long double>(at) - std::complex<long double>(z[j]));
    }
    return f;
  }
};

std::vector<double> split(const std::vector<Complex>& terms) {
  std::vector<double> parts(2 * terms.size());
  for (std::size_t k = 0; k < terms.size(); ++k) {
    parts[k] = terms[k].real(), parts[terms.size() + k] = terms[k].imag();
  }
  return parts;
}

double difference(const std::vector<double>& parts, const std::vector<Complex>& terms) {
  double most = 0.0;
  for (std::size_t k = 0; k < terms.size(); ++k) {
    most = std::max(most, std::abs(Complex(parts[k], parts[terms.size() + k]) - terms[k]));
  }
  return most;
}

}  // namespace

TEST_CASE("the core keeps every digit from q = 1e-300 to 1e300") {
  CHECK(worst_core_error<fmm::FineExp>() < 5e-16);
  CHECK(worst_core_error<fmm::CoarseExp>() < 1.2e-8);
  CHECK(core_once<fmm::FineExp>(0.0) == 0.0);
  CHECK(core_once<fmm::FineExp>(0.3) == Approx(fmm::core_plain(0.3)).epsilon(1e-15));
}

TEST_CASE("P2M by lanes equals P2M said plainly") {
  for (const std::size_t n : {1u, 7u, 8u, 9u, 40u}) {
    const Complex centre(0.3, -4.0);
    const Cluster cluster(n, centre, 0.01);
    const std::vector<Complex> plain = cluster.multipole(centre, 0.01, 25);
    std::vector<double> fast(50);
    fmm::p2m({cluster.x.data(), cluster.y.data(), cluster.gamma.data(), n},
             {centre.real(), centre.imag(), 100.0}, 25, fast.data());
    CHECK(difference(fast, plain) < 1e-15 * static_cast<double>(n + 10));
  }
}

TEST_CASE("a shifted multipole is the multipole of the shifted place") {
  const Complex child(0.52, 0.23), parent(0.5, 0.25);
  const double child_h = 0.02, parent_h = 0.05;
  const Cluster cluster(30, child, child_h);
  for (const int order : {1, 2, 13, 40, 100}) {
    const std::vector<Complex> from = cluster.multipole(child, child_h, order);
    const Complex shift = (child - parent) / parent_h;
    std::vector<Complex> plain(static_cast<std::size_t>(order));
    fmm::m2m(from, shift, child_h / parent_h, plain);
    std::vector<double> fast(2 * plain.size());
    const std::vector<double> parts = split(from);
    const fmm::M2mChild one{parts.data(), shift.real(), shift.imag(), child_h / parent_h};
    fmm::m2m(&one, 1, order, fast.data());
    CHECK(difference(split(plain), cluster.multipole(parent, parent_h, order)) < 1e-13);
    CHECK(difference(fast, plain) < 1e-13);
  }
}

TEST_CASE("a family's multipoles add up in their parent, any number of children") {
  const double child_h = 0.02, parent_h = 0.05;
  const std::vector<Complex> centres{{0.51, 0.22}, {0.47, 0.25}, {0.5, 0.28}, {0.53, 0.26}};
  const Complex parent(0.5, 0.25);
  for (int count = 1; count <= 4; ++count) {
    std::vector<std::vector<double>> parts;
    std::vector<fmm::M2mChild> children;
    std::vector<Complex> plain(26);
    for (int i = 0; i < count; ++i) {
      const Complex centre = centres[static_cast<std::size_t>(i)];
      const std::vector<Complex> from = Cluster(9, centre, child_h).multipole(centre, child_h, 26);
      const Complex shift = (centre - parent) / parent_h;
      fmm::m2m(from, shift, child_h / parent_h, plain);
      parts.push_back(split(from));
      children.push_back({parts.back().data(), shift.real(), shift.imag(), child_h / parent_h});
    }
    std::vector<double> fast(52);
    fmm::m2m(children.data(), count, 26, fast.data());
    CHECK(difference(fast, plain) < 1e-14);
  }
}

TEST_CASE("M2P of enough terms equals the long double sum, and its rows agree") {
  const Complex centre(-2.0, 1.0);
  const double h = 1e-3;
  const Cluster cluster(25, centre, h);
  const std::vector<Complex> terms = cluster.multipole(centre, h, 45);
  const std::vector<double> parts = split(terms);
  constexpr std::size_t n = 4 * lane_count;
  double x[n], y[n], u[n] = {}, v[n] = {};
  test::Uniform uniform(4);
  for (std::size_t i = 0; i < n; ++i) {
    const Complex at = centre + h * std::polar(2.2 + 5.0 * uniform(), 7.0 * uniform());
    x[i] = at.real(), y[i] = at.imag();
  }
  const fmm::M2pSource source{centre.real(), centre.imag(), h, parts.data(), parts.data() + 45, 45};
  fmm::m2p_rows<3>(source, x, y, u, v);
  constexpr std::size_t last = 3 * lane_count;
  fmm::m2p_rows<1>(source, x + last, y + last, u + last, v + last);
  for (std::size_t i = 0; i < n; ++i) {
    const Complex at(x[i], y[i]);
    const std::complex<long double> exact = cluster.field(at);
    const Complex plain = fmm::m2p(terms, centre, h, at);
    const double scale = 25.0 / h;
    CHECK(std::abs(plain - Complex(exact)) < 1e-14 * scale);
    CHECK(std::abs(Complex(v[i], u[i]) - plain) < 1e-14 * scale);
  }
}

TEST_CASE("M2P in single precision agrees with double to single precision") {
  const Complex centre(-2.0, 1.0);
  const double h = 1e-3, size = 5e-3;
  const std::vector<double> parts = split(Cluster(25, centre, h).multipole(centre, h, 30));
  const std::vector<float> singles(parts.begin(), parts.end());
  constexpr std::size_t n = 4 * single_count;
  double x[n], y[n], u[n] = {}, v[n] = {}, single_u[n] = {}, single_v[n] = {};
  float frame_x[n], frame_y[n];
  test::Uniform uniform(6);
  for (std::size_t i = 0; i < n; ++i) {
    const Complex away = std::polar(1.7 * h + size * uniform(), 7.0 * uniform());
    x[i] = centre.real() + away.real(), y[i] = centre.imag() + away.imag();
    frame_x[i] = static_cast<float>(away.real() / size);
    frame_y[i] = static_cast<float>(away.imag() / size);
  }
  fmm::m2p_rows<4>({centre.real(), centre.imag(), h, parts.data(), parts.data() + 30, 30}, x, y, u,
                   v);
  constexpr std::size_t half = n / 2, last = 3 * single_count;
  fmm::m2p_rows<4>({centre.real(), centre.imag(), h, parts.data(), parts.data() + 30, 30}, x + half,
                   y + half, u + half, v + half);
  const fmm::M2pSingleSource source{
      0.0f, 0.0f, static_cast<float>(h / size), 1.0 / h, singles.data(), singles.data() + 30, 30};
  fmm::m2p_single_rows<3>(source, frame_x, frame_y, single_u, single_v);
  fmm::m2p_single_rows<1>(source, frame_x + last, frame_y + last, single_u + last, single_v + last);
  for (std::size_t i = 0; i < n; ++i) {
    const double scale = 25.0 / std::hypot(x[i] - centre.real(), y[i] - centre.imag());
    CHECK(std::hypot(single_u[i] - u[i], single_v[i] - v[i]) < 3e-7 * scale);
  }
}

namespace {

/// The kernel against pair by pair sums, coincident pairs and bare ones among them.
template <class Pair>
double p2p_error(std::size_t sources, std::size_t targets, fmm::Cores cores, bool cored) {
  test::Uniform uniform(sources + 100 * targets);
  fmm::PackedSources packed;
  std::vector<double> x, y, gamma, sigma, core, u(targets), v(targets);
  packed.restart(sources);
  for (std::size_t j = 0; j < std::max(sources, targets); ++j) {
    x.push_back(uniform()), y.push_back(uniform()), gamma.push_back(2 * uniform() - 1);
    sigma.push_back(cored && j % 5 != 0 ? std::pow(10.0, -4 * uniform()) : 0.0);
    core.push_back(sigma[j] * sigma[j]);
    if (j < sources) packed.add(x[j], y[j], gamma[j], Pair::packed_core(core[j]));
  }
  packed.close();
  fmm::p2p<Pair>(packed, {x.data(), y.data(), core.data(), u.data(), v.data(), targets});
  for (auto* values : {&x, &y, &sigma}) values->resize(std::max(sources, targets));
  const auto some = [](const std::vector<double>& values, std::size_t n) {
    return std::span(values).first(n);
  };
  const test::Exact exact = test::exact_velocity(
      {some(x, sources), some(y, sources), some(gamma, sources), some(sigma, sources)},
      {some(x, targets), some(y, targets), some(sigma, targets)}, cores);
  for (std::size_t i = 0; i < targets; ++i) {
    u[i] /= 2 * std::numbers::pi, v[i] /= 2 * std::numbers::pi;
  }
  return test::error_of(u, v, exact).largest;
}

}  // namespace

TEST_CASE("a pair said plainly: bare without core, nothing where they coincide") {
  CHECK(fmm::pair_weight_plain(0.25, 3.0, 0.0) == 12.0);
  CHECK(fmm::pair_weight_plain(0.0, 3.0, 0.0) == 0.0);
  CHECK(fmm::pair_weight_plain(0.0, 3.0, 0.5) == 0.0);
  CHECK(fmm::pair_weight_plain(0.25, 3.0, 0.5) == Approx(12 * (1 - std::exp(-0.5))));
}

TEST_CASE("near sums by lanes equal long double sums, pair by pair") {
  using enum fmm::Cores;
  for (const std::size_t sources : {1u, 8u, 61u}) {
    for (const std::size_t targets : {1u, 2u, 3u, 4u, 30u}) {
      CHECK(p2p_error<fmm::BarePair>(sources, targets, source, false) < 1e-14);
      CHECK(p2p_error<fmm::SourceCorePair<fmm::FineExp>>(sources, targets, source, true) < 1e-14);
      CHECK(p2p_error<fmm::MeanCorePair<fmm::FineExp>>(sources, targets, mean, true) < 1e-14);
      CHECK(p2p_error<fmm::MeanCorePair<fmm::CoarseExp>>(sources, targets, mean, true) < 2e-8);
    }
  }
}

TEST_CASE("single near sums of wide cores agree with double ones to single precision") {
  test::Uniform uniform(8);
  for (const std::size_t n : {1u, 15u, 16u, 300u}) {
    std::vector<double> x, y, core, u(n), v(n), single_u(n), single_v(n);
    fmm::PackedSources plain, packed;
    plain.restart(n), packed.restart(n);
    for (std::size_t j = 0; j < n; ++j) {
      x.push_back(1e3 + 1e-3 * uniform()), y.push_back(1e-3 * uniform());
      core.push_back(std::pow(1e-4 * (1.0 + 9.0 * uniform()), 2));
      const double gamma = 2 * uniform() - 1;
      plain.add(x[j], y[j], gamma, core[j]);
      packed.add(x[j], y[j], gamma, fmm::MeanCorePair<fmm::FineExp>::packed_core(core[j]));
    }
    plain.close(), packed.close();
    fmm::p2p<fmm::MeanCorePair<fmm::FineExp>>(
        packed, {x.data(), y.data(), core.data(), u.data(), v.data(), n});
    fmm::SinglePacked single;
    single.assign<fmm::MeanCorePair<fmm::CoarseExp>>(plain, {1e3 + 5e-4, 5e-4, 5e-4});
    fmm::p2p_single<fmm::MeanCorePair<fmm::CoarseExp>>(
        single, {x.data(), y.data(), core.data(), single_u.data(), single_v.data(), n});
    double wrong = 0.0, whole = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      wrong += std::pow(single_u[i] - u[i], 2) + std::pow(single_v[i] - v[i], 2);
      whole += u[i] * u[i] + v[i] * v[i];
    }
    CHECK(std::sqrt(wrong) <= 3e-7 * std::sqrt(whole));
  }
}
