#include "sph/motion/pressure_system.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "sph/motion/tuning.hpp"
#include "tree/base/told.hpp"

namespace vortree::sph {
namespace {

bool outlet(const Cloud& cloud, std::size_t i, bool outlets) {
  return outlets && cloud.kind[i] == ParticleKind::outlet;
}

std::size_t row_length(const Cloud& cloud, const Stencils& stencils, const BoundaryFits& fits,
                       std::size_t i, bool outlets) {
  if (cloud.inside(i)) return stencils.length(i);
  return outlet(cloud, i, outlets) ? 0 : fits.of(i).neighbors.size();
}

}  // namespace

void PressureSystem::renew(const Cloud& cloud, const Stencils& stencils, const BoundaryFits& fits,
                           bool outlets) {
  const std::size_t n = cloud.size();
  cloud_ = &cloud, fits_ = &fits, outlets_ = outlets;
  pinned_ = !outlets || std::ranges::find(cloud.kind, ParticleKind::outlet) == cloud.kind.end();
  double area = 0;
  for (std::size_t i = 0; i < n; ++i) area += cloud.volume(i);
  pin_ = pin / area;
  rows_.start.assign(n + 1, 0);
  for (std::size_t i = 0; i < n; ++i)
    rows_.start[i + 1] =
        rows_.start[i] + static_cast<std::int32_t>(row_length(cloud, stencils, fits, i, outlets));
  rows_.index.resize(rows_.start[n]), rows_.value.resize(rows_.start[n]);
  rows_.diagonal.resize(n);
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < n; ++i) {
    if (cloud.inside(i))
      row_inside(cloud, stencils, i);
    else if (outlet(cloud, i, outlets))
      rows_.diagonal[i] = -1;
    else
      row_of_node(fits.of(i), i);
  }
  solver_.prepare(rows_);
}

void PressureSystem::row_inside(const Cloud& cloud, const Stencils& stencils, std::size_t i) {
  const double scale = cloud.volume(i);
  std::int32_t k = rows_.start[i];
  double sum = 0;
  stencils.for_each(i, [&](std::size_t j, std::size_t slot) {
    const double value = scale * stencils.laplacian(slot);
    rows_.index[k] = static_cast<std::int32_t>(j), rows_.value[k++] = value;
    sum += value;
  });
  if (pinned_) sum += pin_ * scale;
  rows_.diagonal[i] = sum == 0 ? -1 : -sum;
}

void PressureSystem::row_of_node(const BoundaryFits::Node& node, std::size_t i) {
  std::int32_t k = rows_.start[i];
  for (const auto& [j, weight] : node.neighbors) rows_.index[k] = j, rows_.value[k++] = weight;
  rows_.diagonal[i] = -1;
}

Solved PressureSystem::solve(std::span<const double> source, std::span<const double> given,
                             std::span<double> p, double tolerance) {
  const std::size_t n = cloud_->size();
  right_.resize(n);
  double sum = 0, volume = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (cloud_->inside(i)) {
      right_[i] = source[i] * cloud_->volume(i);
      sum += right_[i], volume += cloud_->volume(i);
    } else {
      right_[i] = outlet(*cloud_, i, outlets_) ? -given[i] : fits_->of(i).lever * given[i];
    }
  }
  const bool closed = pinned_ && fits_->nodes().empty();
  for (std::size_t i = 0; i < n && closed; ++i) right_[i] -= sum / volume * cloud_->volume(i);
  const Solved solved = solver_.solve(right_, p, tolerance, most_iterations);
  if (!(solved.residual < std::min(100 * tolerance, 0.01 + tolerance)))
    throw std::runtime_error("the pressure is not found: a residual of " +
                             tree::told(solved.residual) + " is left after " +
                             std::to_string(solved.iterations) + " iterations");
  if (!pinned_) return solved;
  double mean = 0, all = 0;
  for (std::size_t i = 0; i < n; ++i) mean += cloud_->volume(i) * p[i], all += cloud_->volume(i);
  for (double& value : p) value -= mean / all;
  return solved;
}

}  // namespace vortree::sph
