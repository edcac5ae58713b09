#include "vortex/wall/near_panels.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "vortex/wall/panel_kernel.hpp"
#include "vortex/wall/tuning.hpp"

namespace vortree::vortex {
namespace {

constexpr std::size_t window = exact_aside;
constexpr std::size_t filled = (2 * window + lane_count) / lane_count * lane_count;
static_assert(filled >= 2 * window + 2);  // so many ends have the panels of a window

panel::Vectors load_vectors(const auto& column, std::size_t place) {
  return {load(&column.x[place]), load(&column.y[place])};
}

}  // namespace

NearPanels::NearPanels(const PanelsOfBody& p)
    : panels_(p.middle.size()),
      longest_(std::ranges::max(p.length)),
      even_(std::ranges::min(p.length) == longest_),
      arc_(p.arc.begin(), p.arc.end()),
      length_(wrapped(p.length)),
      counts_(filled) {
  const auto edge = p.edge;
  const auto next = [&](std::size_t i) { return edge[(i + 1) % panels_]; };
  for (const double length : length_) per_length_.push_back(panel::inverse_two_pi / length);
  begin_ = column([&](std::size_t i) { return edge[i]; });
  end_ = column(next);
  chord_ = column([&](std::size_t i) {
    const Vec2 d = next(i) - edge[i];
    return (1 / std::sqrt(dot(d, d))) * d;
  });
  middle_ = column([&](std::size_t i) { return p.middle[i]; });
  tangent_ = column([&](std::size_t i) { return p.tangent[i]; });
  for (std::size_t k : {0, 1}) {
    sample_[k] = column([&](std::size_t i) {
      return Vec2{p.sample.x[2 * i + k], p.sample.y[2 * i + k]};
    });
    stretch_[k] = column([&](std::size_t i) { return Vec2{p.stretch[2 * i + k], 0}; }).x;
  }
  for (std::size_t k = window - aside(); k <= window + aside(); ++k) counts_[k] = 1;
}

bool NearPanels::close(double distance, double arc) const {
  return distance <= exact_within * longest_ && distance <= exact_within * length_at(arc);
}

std::size_t NearPanels::aside() const {
  return std::min(window, (panels_ - 1) / 2);
}

std::size_t NearPanels::places() const {
  return panels_ + window + filled;
}

/// Where the window begins that has the panel at this arc in its middle.
std::size_t NearPanels::first_place(double arc) const {
  if (even_)
    return static_cast<std::size_t>(
        std::max(0.0, std::min(static_cast<double>(panels_), arc / longest_)));
  const auto after = std::upper_bound(arc_.begin() + 1, arc_.end(), arc) - arc_.begin();
  return static_cast<std::size_t>(after - 1);
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
    const Lanes length = load(&length_[p]);
    x += strength * (exact.x - length * point.x);
    y += strength * (exact.y - length * point.y);
  }
  return {sum(x), sum(y)};
}

double NearPanels::stream_correction(Vec2 at, double arc, std::span<const double> sheet) const {
  const std::size_t first = first_place(arc);
  Lanes psi{};
  for (std::size_t k = 0; k < filled; k += lane_count) {
    const std::size_t p = first + k;
    const panel::Vectors a = load_vectors(begin_, p), b = load_vectors(end_, p),
                         middle = load_vectors(middle_, p);
    const panel::Vectors out{(2.0 / 3) * (middle.x - 0.5 * (a.x + b.x)),
                             (2.0 / 3) * (middle.y - 0.5 * (a.y + b.y))};
    const Lanes exact =
        panel::stream_functions(at, {a.x + out.x, a.y + out.y}, {b.x + out.x, b.y + out.y});
    const Lanes strength = load(&sheet[p]) * load(&counts_[k]);
    psi += strength * load(&length_[p]) * (exact - panel::point_stream_functions(at, middle));
  }
  const double b = length_[first + window];
  const double owed = owed_at_end(at, first + window + aside(), true, sheet, b) -
                      owed_at_end(at, first + window - aside(), false, sheet, b);
  return sum(psi) - b * b / 24 * owed;
}

NearPanels::DipoleLayer NearPanels::layer(std::span<const double> x,
                                          std::span<const double> y) const {
  const auto way = [&](std::size_t i) {  // from the middle before to that after
    const double* b = &length_[i + window];
    return b[0] + (b[-1] + b[1]) / 2;
  };
  const auto slope = [&](std::span<const double> of) {
    std::vector<double> rises(panels_);
    for (std::size_t i = 0; i < panels_; ++i)
      rises[i] = (of[(i + 1) % panels_] - of[(i + panels_ - 1) % panels_]) / way(i);
    return wrapped(rises);
  };
  return {wrapped(x), wrapped(y), slope(x), slope(y)};
}

/// With D the integral of (x - x')/r^2 over a chord, and (along, across) the place x from its
/// middle, that of s (x - x')/r^2 is along D - across e x D - b t.
double NearPanels::dipole_correction(Vec2 at, double arc, const DipoleLayer& q) const {
  const std::size_t first = first_place(arc);
  Lanes potential{};
  for (std::size_t k = 0; k < filled; k += lane_count) {
    const std::size_t p = first + k;
    const panel::Vectors a = load_vectors(begin_, p), b = load_vectors(end_, p),
                         t = load_vectors(chord_, p), turned = panel::velocities(at, a, b, t),
                         point = panel::point_velocities(at, load_vectors(middle_, p));
    const panel::Vectors from = at - panel::Vectors{0.5 * (a.x + b.x), 0.5 * (a.y + b.y)};
    const Lanes along = panel::dot(from, t), across = t.x * from.y - t.y * from.x,
                length = load(&length_[p]), whole = panel::inverse_two_pi * length;
    const Lanes even = load(&q.x[p]) * (turned.y - length * point.y) -
                       load(&q.y[p]) * (turned.x - length * point.x);
    const Lanes sloping =
        load(&q.slope_x[p]) * (along * turned.y - across * turned.x - whole * t.x) -
        load(&q.slope_y[p]) * (along * turned.x + across * turned.y + whole * t.y);
    potential += load(&counts_[k]) * (even + sloping);
  }
  return sum(potential);
}

/// How -gamma ln r/(2 pi) ds/dt changes with t, in units of b^2, at the beginning of a window, that
/// of the panel at this place, or at the end of its last.
double NearPanels::owed_at_end(Vec2 at, std::size_t place, bool last, std::span<const double> sheet,
                               double b) const {
  const Column& ends = last ? end_ : begin_;
  const Vec2 d = Vec2{ends.x[place], ends.y[place]} - at;
  const double gamma = 1.5 * sheet[place] - 0.5 * sheet[last ? place - 1 : place + 1];
  const std::size_t after = last ? place + 1 : place,
                    before = after > 0 ? after - 1 : panels_ - 1;
  const double here = (length_[before] + length_[after]) / (2 * b),
               more = (length_[after] - length_[before]) / (b * b);
  const double along = dot(d, {chord_.x[place], chord_.y[place]}) / dot(d, d);
  return -panel::inverse_two_pi * gamma * (here * here * along + more * std::log(dot(d, d)) / 2);
}

void NearPanels::add_missed(Vec2 at, double arc, double gamma, std::span<double> missed) const {
  const std::size_t first = first_place(arc);
  for (std::size_t k = 0; k < filled; k += lane_count) {
    const std::size_t p = first + k;
    // Velocity there of a vortex here, or minus that here of one there.
    const panel::Vectors u = panel::point_velocities(at, load_vectors(sample_[0], p),
                                                     load(&stretch_[0][p])),
                         v = panel::point_velocities(at, load_vectors(sample_[1], p),
                                                     load(&stretch_[1][p]));
    const panel::Vectors both{u.x + v.x, u.y + v.y};
    const Lanes sampled = -0.5 * panel::dot(both, load_vectors(tangent_, p));
    const Lanes exact =
        load(&per_length_[p]) * panel::angles(at, load_vectors(begin_, p), load_vectors(end_, p));
    const Lanes strength = gamma * load(&counts_[k]);
    store(&missed[p], load(&missed[p]) + strength * (exact - sampled));
  }
}

void NearPanels::add_aside(Vec2 at, const ThreePoints& points, double arc, double gamma,
                           std::span<double> missed) const {
  const std::size_t first = first_place(arc);
  std::array<double, filled + 1> seen{};  // a panel's end is the next one's beginning
  for (std::size_t k = 0; k < filled; k += lane_count)
    store(&seen[k], panel::angles_aside(at, points, load_vectors(begin_, first + k)));
  for (std::size_t k = 0; k < filled; ++k)
    missed[first + k] += per_length_[first + k] * gamma * counts_[k] * (seen[k + 1] - seen[k]);
}

void NearPanels::add_aside_everywhere(Vec2 at, const ThreePoints& points, double gamma,
                                      std::span<double> missed) const {
  std::array<double, 2 * lane_count> seen;  // from the ends of some panels, and from the next ones
  const auto see = [&](std::size_t k, double* to) {
    store(to, panel::angles_aside(at, points, load_vectors(begin_, window + k)));
  };
  see(0, &seen[0]);
  for (std::size_t k = 0; k < panels_; k += lane_count) {
    see(k + lane_count, &seen[lane_count]);
    const std::size_t count = std::min<std::size_t>(lane_count, panels_ - k);
    for (std::size_t lane = 0; lane < count; ++lane) {
      const std::size_t place = window + k + lane;
      missed[place] += per_length_[place] * gamma * (seen[lane + 1] - seen[lane]);
    }
    std::copy_n(&seen[lane_count], lane_count, &seen[0]);
  }
}

}  // namespace vortree::vortex
