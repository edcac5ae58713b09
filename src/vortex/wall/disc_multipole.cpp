#include "vortex/wall/disc_multipole.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "fmm/series/multipole_kernel.hpp"
#include "vortex/wall/tuning.hpp"

namespace vortree::vortex {
namespace {

constexpr int together = disc_registers * lane_count;
constexpr double inverse_two_pi = 0.5 * std::numbers::inv_pi;

/// Terms of a series in R/r that leave out less than the tolerance.
int terms_for(double radii) {
  const double terms = std::log(disc_tolerance * (1 - 1 / radii)) / -std::log(radii);
  return static_cast<int>(std::clamp(std::ceil(terms), 1.0, static_cast<double>(fmm::most_terms)));
}

}  // namespace

Disc::Disc(tree::Points places) {
  const auto n = static_cast<double>(places.size());
  const auto place = [&](std::size_t i) { return Vec2{places.x[i], places.y[i]}; };
  for (std::size_t i = 0; i < places.size(); ++i) centre += (1 / n) * place(i);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Vec2 d = place(i) - centre;
    radius = std::max(radius, std::sqrt(dot(d, d)));
  }
}

DiscMultipole::DiscMultipole(const Disc& disc, tree::Points at, std::span<const double> gamma)
    : disc_(disc), coefficients_(2 * fmm::most_terms) {
  fmm::p2m({at.x.data(), at.y.data(), gamma.data(), at.size()},
           {disc.centre.x, disc.centre.y, 1 / disc.radius}, fmm::most_terms, coefficients_.data());
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
      const Vec2 d = Vec2{x[k], y[k]} - disc_.centre;
      least2 = std::min(least2, dot(d, d));
    }
    const int terms = terms_for(std::sqrt(least2) / disc_.radius);
    fmm::m2p_rows<disc_registers>(
        {disc_.centre.x, disc_.centre.y, disc_.radius, coefficients_.data(),
         coefficients_.data() + fmm::most_terms, terms},
        x.data(), y.data(), u.data(), v.data());
    for (std::size_t k = 0; k < some.size(); ++k) {
      result.u[some[k]] += inverse_two_pi * u[k];
      result.v[some[k]] += inverse_two_pi * v[k];
    }
  }
}

}  // namespace vortree::vortex
