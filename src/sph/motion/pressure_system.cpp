#include "sph/motion/pressure_system.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "base/rounded.hpp"
#include "sph/motion/tuning.hpp"
#include "tree/base/simd.hpp"

namespace vortree::sph {
namespace {

constexpr std::size_t slice_lanes = SlicedDoubles::lanes;

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
  rows_.lay_out(n,
                [&](std::size_t i) { return 1 + row_length(cloud, stencils, fits, i, outlets); });
#pragma omp parallel for schedule(static)
  for (std::size_t slice = 0; slice < rows_.slices(); ++slice) {
    rows_inside(cloud, stencils, slice);
    for (std::size_t i = slice * slice_lanes; i < std::min((slice + 1) * slice_lanes, n); ++i)
      if (!cloud.inside(i)) row_of_node(cloud, i);
  }
  solver_.prepare(rows_);
}

/// Rows of a slice, and zeros for those that are none inside.
void PressureSystem::rows_inside(const Cloud& cloud, const Stencils& stencils, std::size_t slice) {
  const std::size_t first = rows_.begin[slice] * slice_lanes,
                    end = rows_.begin[slice + 1] * slice_lanes;
  for (std::size_t lane = 0; lane < slice_lanes; lane += lane_count) {
    const std::size_t from = slice * slice_lanes + lane, group = from / lane_count;
    Lanes scale, sum{}, alone{};
    for (int k = 0; k < lane_count; ++k) {
      const std::size_t i = from + static_cast<std::size_t>(k);
      scale[k] = i < cloud.size() && cloud.inside(i) ? cloud.volume(i) : 0;
      alone[k] = i < cloud.size() ? -1 : 0;
      rows_.index[first + lane + k] = static_cast<std::int32_t>(std::min(i, cloud.size() - 1));
    }
    const std::size_t slots =
        group < stencils.groups() ? stencils.first(group + 1) - stencils.first(group) : 0;
    for (std::size_t k = 0, at = first + slice_lanes + lane; at < end; ++k, at += slice_lanes) {
      const std::size_t slot =
          (stencils.first(std::min(group, stencils.groups())) + k) * lane_count;
      Lanes value{};
      // What stencils have beyond the last particle may be anything.
      if (k < slots) value = scale > Lanes{} ? scale * stencils.laplacians(slot) : Lanes{};
      const std::int32_t* index =
          k < slots ? stencils.indices() + slot : rows_.index.data() + first + lane;
      std::copy_n(index, lane_count, rows_.index.data() + at);
      store(rows_.value.data() + at, value);
      sum += value;
    }
    if (pinned_) sum += pin_ * scale;
    store(rows_.value.data() + first + lane, sum == Lanes{} ? alone : -sum);
  }
}

void PressureSystem::row_of_node(const Cloud& cloud, std::size_t i) {
  std::size_t k = rows_.begin[i / slice_lanes] * slice_lanes + i % slice_lanes;
  rows_.value[k] = -1;
  if (outlet(cloud, i, outlets_)) return;
  for (const auto& [j, weight] : fits_->of(i).neighbors) {
    k += slice_lanes;
    rows_.index[k] = j, rows_.value[k] = weight;
  }
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
                             rounded(solved.residual, 3) + " is left after " +
                             std::to_string(solved.iterations) + " iterations");
  if (!pinned_) return solved;
  double mean = 0, all = 0;
  for (std::size_t i = 0; i < n; ++i) mean += cloud_->volume(i) * p[i], all += cloud_->volume(i);
  for (double& value : p) value -= mean / all;
  return solved;
}

}  // namespace vortree::sph
