#include "sph/operators/boundary_fits.hpp"

#include <array>
#include <cmath>
#include <optional>

#include "sph/operators/tuning.hpp"
#include "sph/pairs/kernel_shapes.hpp"

namespace vortree::sph {
namespace {

constexpr int most_terms = 5;
using Terms = std::array<double, most_terms>;

/// A neighbor as the node sees it.
struct Seen {
  std::int32_t index;
  double along, weight;
  Terms terms;
  double of_value = 0;  // its share of the node's value
};

std::vector<Seen> neighbors_inside(const Cloud& cloud, const Stencils& stencils, std::size_t i,
                                   double reach) {
  std::vector<Seen> seen;
  const double s = cloud.spacing[i];
  stencils.for_each(i, [&](std::size_t j, std::size_t slot) {
    if (!cloud.inside(j)) return;
    const Vec2 d = stencils.offset(slot), normal = cloud.normal(i);
    const double other = cloud.spacing[j], pair = 0.5 * reach * (s + other);
    // The kernel's support is 2 h.
    const double w =
        WendlandC4<2>::shape(2 * std::sqrt(dot(d, d)) / pair) * other * other / (s * s);
    if (!(w > 1e-6)) return;
    const double n = dot(d, normal), t = normal.x * d.y - normal.y * d.x;
    const double N = n / (reach * s), T = t / (reach * s);
    seen.push_back({static_cast<std::int32_t>(j), n, w, {1, T, N * N, N * T, T * T}, 0});
  });
  return seen;
}

/// Row 0 of the inverse of the moment matrix, or nothing if some pivot is too small.
bool first_row(const std::vector<Seen>& seen, int terms, Terms& row) {
  double a[most_terms][most_terms] = {}, l[most_terms][most_terms] = {};
  for (const Seen& one : seen)
    for (int r = 0; r < terms; ++r)
      for (int c = 0; c <= r; ++c) a[r][c] += one.weight * one.terms[r] * one.terms[c];
  for (int r = 0; r < terms; ++r)
    for (int c = 0; c <= r; ++c) {
      double sum = a[r][c];
      for (int k = 0; k < c; ++k) sum -= l[r][k] * l[c][k];
      if (r == c && !(sum > least_pivot * a[r][r])) return false;
      l[r][c] = r == c ? std::sqrt(sum) : sum / l[c][c];
    }
  Terms y{};
  for (int r = 0; r < terms; ++r) {
    double sum = r == 0;
    for (int k = 0; k < r; ++k) sum -= l[r][k] * y[k];
    y[r] = sum / l[r][r];
  }
  for (int r = terms - 1; r >= 0; --r) {
    double sum = y[r];
    for (int k = r + 1; k < terms; ++k) sum -= l[k][r] * row[k];
    row[r] = sum / l[r][r];
  }
  return true;
}

/// The weights of so many terms and their sum with signs left out, or nothing.
std::optional<double> find_weights(std::vector<Seen>& seen, int terms) {
  Terms row{};
  if (!first_row(seen, terms, row)) return {};
  double sizes = 0;
  for (Seen& one : seen) {
    double a = 0;
    for (int k = 0; k < terms; ++k) a += row[k] * one.terms[k];
    one.of_value = a * one.weight;
    sizes += std::abs(one.of_value);
  }
  return sizes;
}

BoundaryFits::Node node(const Cloud& cloud, const Stencils& stencils, std::size_t i, double reach) {
  BoundaryFits::Node made{static_cast<std::int32_t>(i), {}, 0};
  std::vector<Seen> seen = neighbors_inside(cloud, stencils, i, reach);
  int terms = seen.size() >= 8 ? 5 : seen.size() >= 4 ? 2 : 1;
  const auto poor = [](std::optional<double> sizes) { return !sizes || *sizes > most_amplified; };
  while (terms > 0 && poor(find_weights(seen, terms))) terms = terms == 5 ? 2 : terms - 1;
  for (const Seen& one : seen) {
    made.neighbors.push_back({one.index, one.of_value});
    made.lever += one.of_value * one.along;
  }
  return made;
}

}  // namespace

void BoundaryFits::renew(const Cloud& cloud, const Stencils& stencils,
                         const OperatorOptions& options) {
  const double reach = std::min(options.reach, boundary_reach);
  number_.assign(cloud.size(), -1);
  std::size_t count = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (!cloud.inside(i)) number_[i] = static_cast<std::int32_t>(count++);
  nodes_.resize(count);
#pragma omp parallel for schedule(dynamic, 64)
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (number_[i] >= 0) nodes_[number_[i]] = node(cloud, stencils, i, reach);
}

}  // namespace vortree::sph
