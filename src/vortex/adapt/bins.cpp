#include "vortex/adapt/bins.hpp"

#include "vortex/adapt/tuning.hpp"

namespace vortree::vortex {

Bins::Bins(std::span<const double> x, std::span<const double> y, double side) : side_(side) {
  const auto n = static_cast<std::ptrdiff_t>(x.size());
  if (n > 0) {
    const auto [x0, x1] = std::minmax_element(x.begin(), x.end());
    const auto [y0, y1] = std::minmax_element(y.begin(), y.end());
    const double width = *x1 - *x0, height = *y1 - *y0;
    const double most = bins_a_blob * static_cast<double>(n);
    side_ = std::max({side_, std::sqrt(width * height / most), width / most, height / most});
    x0_ = *x0;
    y0_ = *y0;
    nx_ = static_cast<std::int64_t>(width / side_) + 1;
    ny_ = static_cast<std::int64_t>(height / side_) + 1;
  }
  std::vector<std::uint32_t> cell_of(n);
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t i = 0; i < n; ++i) cell_of[i] = static_cast<std::uint32_t>(cell(x[i], y[i]));
  start_.assign(nx_ * ny_ + 2, 0);
  for (std::uint32_t c : cell_of) ++start_[c + 2];
  for (std::size_t c = 2; c < start_.size(); ++c) start_[c] += start_[c - 1];
  // start_[c + 1] runs from the first to the last place of cell c while they are filled.
  order_.resize(n);
  for (std::ptrdiff_t i = 0; i < n; ++i)
    order_[start_[cell_of[i] + 1]++] = static_cast<std::uint32_t>(i);
}

}  // namespace vortree::vortex
