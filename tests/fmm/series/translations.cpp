#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <span>
#include <vector>

#include "fmm/series/specification.hpp"
#include "fmm/series/translation_kernel.hpp"
#include "point_sets.hpp"

using namespace vortree;
using fmm::Complex;

namespace {

/// A series for each lane, and the same said plainly.
template <class Number>
struct Series {
  static constexpr int lanes = fmm::VectorOf<Number>::count;
  std::vector<fmm::ComplexLanes<Number>> vectors;
  std::vector<std::vector<Complex>> plain;

  /// Zero, or coefficients of random signs that fall as those of evenly filled cells do.
  explicit Series(int order, test::Uniform* uniform = nullptr, double fall = 0.7)
      : vectors(static_cast<std::size_t>(order)),
        plain(lanes, std::vector<Complex>(static_cast<std::size_t>(order))) {
    for (int k = 0; k < order; ++k) {
      vectors[k] = fmm::ComplexLanes<Number>{};
      for (int i = 0; uniform != nullptr && i < lanes; ++i) {
        const double size = std::pow(fall, k);
        vectors[k].re[i] = static_cast<Number>(size * (2 * (*uniform)() - 1));
        vectors[k].im[i] = static_cast<Number>(size * (2 * (*uniform)() - 1));
        plain[i][k] = Complex(vectors[k].re[i], vectors[k].im[i]);
      }
    }
  }

  /// Largest difference of the two, counted in round-off of the largest terms that were added.
  [[nodiscard]] double difference(const std::vector<double>& scale) const {
    double worst = 0.0;
    for (std::size_t k = 0; k < vectors.size(); ++k) {
      for (int i = 0; i < lanes; ++i) {
        const Complex fast(vectors[k].re[i], vectors[k].im[i]);
        worst = std::max(worst, std::abs(fast - plain[i][k]) / scale[k]);
      }
    }
    return worst / std::numeric_limits<Number>::epsilon();
  }
};

std::array<int, fmm::orbit_count> terms_of(int order) {
  std::array<int, fmm::orbit_count> terms{};
  for (int o = 0; o < fmm::orbit_count; ++o) terms[o] = std::max(1, order - o);
  return terms;
}

/// Sums of |terms| of an operator on coefficients below fall^k: what its round-off goes by.
template <class Operator>
std::vector<double> sizes(int order, double fall, Operator apply) {
  std::vector<Complex> from(static_cast<std::size_t>(order)), to(from.size());
  for (int k = 0; k < order; ++k) from[k] = std::pow(fall, k);
  apply(from, to);
  std::vector<double> size;
  for (const Complex value : to) size.push_back(std::abs(value) + 1e-300);
  return size;
}

constexpr Complex turns[4] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};

/// Worst round-off of M2L with the sources of an orbit that `present` names, bit by bit.
template <class Number>
double m2l_error(const fmm::TranslationTables<Number>& tables, int o, unsigned present,
                 test::Uniform& uniform) {
  const int order = tables.order, terms = tables.orbit[o].terms;
  const Complex d(fmm::orbits[o].x, fmm::orbits[o].y);
  Series<Number> local(order, &uniform), nothing(order);
  std::vector<Series<Number>> sources;
  for (int m = 0; m < 4; ++m) sources.emplace_back(order, &uniform);
  const fmm::ComplexLanes<Number>* from[4];
  for (int m = 0; m < 4; ++m) {
    from[m] = (present >> m & 1 ? sources[m] : nothing).vectors.data();
    for (int i = 0; present >> m & 1 && i < Series<Number>::lanes; ++i) {
      const std::span<const Complex> some = std::span(sources[m].plain[i]).first(terms);
      fmm::m2l(some, d * turns[m], std::span(local.plain[i]).first(terms));
    }
  }
  std::vector<fmm::ComplexLanes<Number>> room(4 * static_cast<std::size_t>(order));
  fmm::add_orbit<Number>(tables, o, from, room.data(), local.vectors.data());
  // a positive D makes all terms of one sign
  std::vector<double> scale =
      sizes(order, 0.7, [&](auto& c, auto& to) { fmm::m2l(c, std::abs(d), to); });
  for (int l = 0; l < order; ++l) scale[l] = std::max(scale[l], std::pow(0.7, l));
  return local.difference(scale);
}

template <class Number>
void check_m2l() {
  test::Uniform uniform(3);
  for (int order = 1; order <= 40; ++order) {
    CAPTURE(order);
    const fmm::TranslationTables<Number> tables(order, terms_of(order));
    double worst = 0.0;
    for (int o = 0; o < fmm::orbit_count; ++o) {
      for (const unsigned present : {1u, 2u, 4u, 8u, 15u}) {
        worst = std::max(worst, m2l_error(tables, o, present, uniform));
      }
    }
    CHECK(worst < 40.0);
  }
}

template <class Number>
void check_kin() {
  test::Uniform uniform(4);
  for (int order = 1; order <= 40; ++order) {
    CAPTURE(order);
    const fmm::TranslationTables<Number> tables(order, terms_of(order));
    std::vector<fmm::ComplexLanes<Number>> room(static_cast<std::size_t>(order));
    for (int q = 0; q < 4; ++q) {
      const Complex d((q % 2 - 0.5) / 2, (q / 2 - 0.5) / 2);
      const Series<Number> child(order, &uniform), parent(order, &uniform);
      Series<Number> up(order, &uniform), down(order, &uniform);
      for (int i = 0; i < Series<Number>::lanes; ++i) {
        fmm::m2m(child.plain[i], d, 0.5, up.plain[i]);
        std::ranges::fill(down.plain[i], Complex{});
        fmm::l2l(parent.plain[i], d, 0.5, down.plain[i]);
      }
      fmm::add_child<Number>(tables, q, child.vectors.data(), room.data(), up.vectors.data());
      fmm::shift_to_child<Number>(tables, q, parent.vectors.data(), room.data(),
                                  down.vectors.data());
      const double length = std::abs(d);
      CHECK(up.difference(sizes(order, 0.7, [&](auto& c, auto& to) {
        fmm::m2m(c, length, 0.5, to);
        for (std::size_t k = 0; k < to.size(); ++k) to[k] += std::pow(0.7, k);
      })) < 40.0);
      CHECK(down.difference(sizes(
                order, 0.7, [&](auto& c, auto& to) { fmm::l2l(c, length, 0.5, to); })) < 40.0);
    }
  }
}

template <class Number>
void check_moves() {
  constexpr int lanes = fmm::VectorOf<Number>::count, padded = 2 * lanes;
  std::vector<std::vector<Number>> cells(lanes, std::vector<Number>(2 * padded));
  const Number* from[lanes];
  Number* to[lanes];
  const auto value = [](int cell, int k) { return static_cast<Number>(100 * cell + k); };
  for (int i = 0; i < lanes; ++i) {
    for (int k = 0; k < 2 * padded; ++k) cells[i][k] = value(i, k);
    from[i] = cells[i].data();
    to[i] = i % 3 == 1 ? nullptr : cells[i].data();
  }
  std::vector<fmm::ComplexLanes<Number>> side(padded);
  fmm::gather_series<Number>(from, padded, side.data());
  for (int k = 0; k < padded; ++k) {
    for (int i = 0; i < lanes; ++i) {
      CHECK(side[k].re[i] == value(i, k));
      CHECK(side[k].im[i] == value(i, padded + k));
    }
    side[k].re += 1;
    side[k].im += 2;
  }
  fmm::scatter_series<Number>(side.data(), padded, to);
  for (int i = 0; i < lanes; ++i) {
    for (int k = 0; k < padded; ++k) {
      CHECK(cells[i][k] == value(i, k) + (to[i] == nullptr ? 0 : 1));
      CHECK(cells[i][padded + k] == value(i, padded + k) + (to[i] == nullptr ? 0 : 2));
    }
  }
}

}  // namespace

TEST_CASE("M2L by orbits equals M2L said plainly, at each of 40 offsets, orders 1 to 40") {
  check_m2l<double>();
  check_m2l<float>();
}

TEST_CASE("M2M and L2L by lanes equal those said plainly, in every quadrant, orders 1 to 40") {
  check_kin<double>();
  check_kin<float>();
}

TEST_CASE("series go side by side and back; cells that are not there are left alone") {
  check_moves<double>();
  check_moves<float>();
}
