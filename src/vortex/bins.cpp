#include "vortex/bins.hpp"

namespace vortree::vortex {

Bins::Bins(std::span<const double> x, std::span<const double> y, double side)
    : side_(side) {
  if (!x.empty()) {
    const auto [x0, x1] = std::minmax_element(x.begin(), x.end());
    const auto [y0, y1] = std::minmax_element(y.begin(), y.end());
    const double width = *x1 - *x0, height = *y1 - *y0;
    const double most = 16.0 * static_cast<double>(x.size());
    side_ = std::max({side_, std::sqrt(width * height / most), width / most, height / most});
    x0_ = *x0;
    y0_ = *y0;
    nx_ = static_cast<std::int64_t>(width / side_) + 1;
    ny_ = static_cast<std::int64_t>(height / side_) + 1;
  }
  std::vector<std::uint32_t> cell_of(x.size());
  start_.assign(nx_ * ny_ + 1, 0);
  for (std::size_t i = 0; i < x.size(); ++i) {
    cell_of[i] = static_cast<std::uint32_t>(cell(x[i], y[i]));
    ++start_[cell_of[i] + 1];
  }
  for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
  order_.resize(x.size());
  std::vector<std::uint32_t> next = start_;
  for (std::size_t i = 0; i < x.size(); ++i)
    order_[next[cell_of[i]]++] = static_cast<std::uint32_t>(i);
}

}  // namespace vortree::vortex
