#include "vortex/disc_multipole.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "fmm/multipole_kernel.hpp"

namespace vortree::vortex {
namespace {

constexpr double tolerance = 1e-10, nearest = 1.14;  // radii
constexpr int rows = 3, together = rows * lane_count;
constexpr double inverse_two_pi = 0.5 * std::numbers::inv_pi;

/// Terms of a series in R/r that leave out less than the tolerance.
int terms_for(double radii) {
  const double terms = std::log(tolerance * (1 - 1 / radii)) / -std::log(radii);
  return std::clamp(static_cast<int>(std::ceil(terms)), 1, fmm::most_terms);
}

}  // namespace

DiscMultipole::DiscMultipole(tree::Points at, std::span<const double> gamma)
    : coefficients_(2 * fmm::most_terms) {
  const auto n = static_cast<double>(at.size());
  for (std::size_t i = 0; i < at.size(); ++i) centre_ = centre_ + (1 / n) * Vec2{at.x[i], at.y[i]};
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Vec2 d = Vec2{at.x[i], at.y[i]} - centre_;
    radius_ = std::max(radius_, std::sqrt(dot(d, d)));
  }
  nearest2_ = nearest * nearest * radius_ * radius_;
  fmm::p2m({at.x.data(), at.y.data(), gamma.data(), at.size()}, {centre_.x, centre_.y, 1 / radius_},
           fmm::most_terms, coefficients_.data());
}

void DiscMultipole::add_velocity(tree::Points targets, std::span<const std::uint32_t> named,
                                 Velocities& result) const {
  const std::ptrdiff_t groups = (named.size() + together - 1) / together;
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t group = 0; group < groups; ++group) {
    const auto some = named.subspan(group * together)
                          .first(std::min<std::size_t>(together, named.size() - group * together));
    std::array<double, together> x, y, u{}, v{};
    double least2 = INFINITY;
    for (std::size_t k = 0; k < together; ++k) {
      const std::uint32_t i = some[std::min(k, some.size() - 1)];
      x[k] = targets.x[i];
      y[k] = targets.y[i];
      const Vec2 d = Vec2{x[k], y[k]} - centre_;
      least2 = std::min(least2, dot(d, d));
    }
    const int terms = terms_for(std::sqrt(least2) / radius_);
    fmm::m2p_rows<rows>({centre_.x, centre_.y, radius_, coefficients_.data(),
                         coefficients_.data() + fmm::most_terms, terms},
                        x.data(), y.data(), u.data(), v.data());
    for (std::size_t k = 0; k < some.size(); ++k) {
      result.u[some[k]] += inverse_two_pi * u[k];
      result.v[some[k]] += inverse_two_pi * v[k];
    }
  }
}

}  // namespace vortree::vortex
