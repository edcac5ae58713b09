#include "vortex/wall/near_panels.hpp"

#include <algorithm>

#include "vortex/wall/panel_kernel.hpp"
#include "vortex/wall/tuning.hpp"

namespace vortree::vortex {
namespace {

constexpr std::size_t window = exact_aside;
constexpr std::size_t filled = (2 * window + lane_count) / lane_count * lane_count;
static_assert(filled >= 2 * window + 1);

panel::Vectors load_vectors(const auto& column, std::size_t place) {
  return {load(&column.x[place]), load(&column.y[place])};
}

}  // namespace

NearPanels::NearPanels(std::span<const Vec2> edge, std::span<const Vec2> middle,
                       std::span<const Vec2> tangent, tree::Points samples, double length)
    : panels_(middle.size()), length_(length), counts_(filled) {
  const auto next = [&](std::size_t i) { return edge[(i + 1) % panels_]; };
  begin_ = column([&](std::size_t i) { return edge[i]; });
  end_ = column(next);
  chord_ = column([&](std::size_t i) {
    const Vec2 d = next(i) - edge[i];
    return (1 / std::sqrt(dot(d, d))) * d;
  });
  middle_ = column([&](std::size_t i) { return middle[i]; });
  tangent_ = column([&](std::size_t i) { return tangent[i]; });
  for (std::size_t k : {0, 1})
    sample_[k] = column([&](std::size_t i) {
      return Vec2{samples.x[2 * i + k], samples.y[2 * i + k]};
    });
  const std::size_t reach = std::min(window, (panels_ - 1) / 2);
  for (std::size_t k = window - reach; k <= window + reach; ++k) counts_[k] = 1;
}

std::size_t NearPanels::places() const {
  return panels_ + window + filled;
}

/// Where the window begins that has the panel at this arc in its middle.
std::size_t NearPanels::first_place(double arc) const {
  return static_cast<std::size_t>(
      std::max(0.0, std::min(static_cast<double>(panels_), arc / length_)));
}

NearPanels::Column NearPanels::column(auto of_panel) const {
  Column result;
  for (std::size_t place = 0; place < places(); ++place) {
    const Vec2 value = of_panel((place + panels_ * window - window) % panels_);
    result.x.push_back(value.x);
    result.y.push_back(value.y);
  }
  return result;
}

std::vector<double> NearPanels::wrapped(std::span<const double> values) const {
  return column([&](std::size_t i) { return Vec2{values[i], 0}; }).x;
}

std::vector<double> NearPanels::unwrapped(std::span<const double> values) const {
  std::vector<double> sum(panels_);
  for (std::size_t place = 0; place < places(); ++place)
    sum[(place + panels_ * window - window) % panels_] += values[place];
  return sum;
}

Vec2 NearPanels::correction(Vec2 at, double arc, std::span<const double> sheet) const {
  const std::size_t first = first_place(arc);
  Lanes x{}, y{};
  for (std::size_t k = 0; k < filled; k += lane_count) {
    const std::size_t p = first + k;
    const panel::Vectors exact = panel::velocities(at, load_vectors(begin_, p),
                                                   load_vectors(end_, p), load_vectors(chord_, p));
    const panel::Vectors point = panel::point_velocities(at, load_vectors(middle_, p));
    const Lanes strength = load(&sheet[p]) * load(&counts_[k]);
    x += strength * (exact.x - length_ * point.x);
    y += strength * (exact.y - length_ * point.y);
  }
  return {sum(x), sum(y)};
}

void NearPanels::add_missed(Vec2 at, double arc, double gamma, std::span<double> missed) const {
  const std::size_t first = first_place(arc);
  for (std::size_t k = 0; k < filled; k += lane_count) {
    const std::size_t p = first + k;
    // Velocity there of a vortex here, or minus that here of one there.
    const panel::Vectors u = panel::point_velocities(at, load_vectors(sample_[0], p)),
                         v = panel::point_velocities(at, load_vectors(sample_[1], p));
    const panel::Vectors both{u.x + v.x, u.y + v.y};
    const Lanes sampled = -0.5 * panel::dot(both, load_vectors(tangent_, p));
    const Lanes exact = panel::inverse_two_pi / length_ *
                        panel::angles(at, load_vectors(begin_, p), load_vectors(end_, p));
    const Lanes strength = gamma * load(&counts_[k]);
    store(&missed[p], load(&missed[p]) + strength * (exact - sampled));
  }
}

}  // namespace vortree::vortex
