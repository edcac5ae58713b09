#include "vortex/wall.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace vortree::vortex {
namespace {

constexpr double inverse_two_pi = 0.5 * std::numbers::inv_pi;
constexpr double near_panels = 3;     // exact integrals for points closer to the wall than this
constexpr std::ptrdiff_t window = 6;  // ... and for the panels this far along it
const double gauss = 0.5 / std::sqrt(3.0);

/// Angle under which `at` sees the way from a to b.
double angle(Vec2 at, Vec2 a, Vec2 b) {
  const Vec2 p = a - at, q = b - at;
  return std::atan2(p.x * q.y - p.y * q.x, dot(p, q));
}

/// Velocity of a bare vortex of circulation 1 at `source`.
Vec2 point_velocity(Vec2 at, Vec2 source) {
  const Vec2 d = at - source;
  const double w = inverse_two_pi / dot(d, d);
  return {-w * d.y, w * d.x};
}

/// Velocity of a straight sheet of strength 1 from a to b.
Vec2 panel_velocity(Vec2 at, Vec2 a, Vec2 b) {
  const Vec2 p = at - a, q = at - b, d = b - a;
  const double along = 0.5 * std::log(dot(p, p) / dot(q, q));
  const double seen = angle(at, a, b);
  const Vec2 t = (1 / std::sqrt(dot(d, d))) * d;
  // In the panel's frame: (seen, along)/(2 pi) with a sign from u - i v = log((z-a)/(z-b))/(2 pi
  // i).
  const double parallel = -inverse_two_pi * seen, across = inverse_two_pi * along;
  return {parallel * t.x - across * t.y, parallel * t.y + across * t.x};
}

/// The panels next to a wall point, wrapped around the curve.
template <class Use>
void for_panels_near(double arc, double length, std::ptrdiff_t panels, Use use) {
  const auto here = static_cast<std::ptrdiff_t>(arc / length);
  const std::ptrdiff_t reach = std::min(window, (panels - 1) / 2);
  for (std::ptrdiff_t k = here - reach; k <= here + reach; ++k) use((k + panels) % panels);
}

/// The sheet's equations and, last, its circulation; their multiplier takes up what a discrete slip
/// misses of being free of circulation.
std::vector<double> sheet_equations(const Shape& shape, const std::vector<Vec2>& middle,
                                    double length) {
  const std::size_t n = middle.size();
  std::vector<double> a((n + 1) * (n + 1));
  for (std::size_t i = 0; i < n; ++i) {
    const WallPoint at = shape.nearest(middle[i]);
    double* row = &a[i * (n + 1)];
    for (std::size_t j = 0; j < n; ++j) {
      const Vec2 d = middle[i] - middle[j];
      const double k = i == j ? at.curvature / 2 : dot(at.normal, d) / dot(d, d);
      row[j] = (i == j ? 0.5 : 0.0) - inverse_two_pi * length * k;
    }
    row[n] = 1;
    a[n * (n + 1) + i] = length;
  }
  return a;
}

}  // namespace

Wall::Wall(std::unique_ptr<Shape> shape, int panels) : shape_(std::move(shape)) {
  if (panels < 8)
    throw std::invalid_argument(std::to_string(panels) + " panels; a wall needs at least 8");
  length_ = shape_->perimeter() / panels;
  for (int i = 0; i < panels; ++i) {
    edge_.push_back(shape_->point(i * length_));
    middle_.push_back(shape_->point((i + 0.5) * length_));
    tangent_.push_back(shape_->nearest(middle_.back()).tangent());
    middle_x_.push_back(middle_.back().x);
    middle_y_.push_back(middle_.back().y);
    for (double offset : {0.5 - gauss, 0.5 + gauss}) {
      const Vec2 p = shape_->point((i + offset) * length_);
      sample_x_.push_back(p.x);
      sample_y_.push_back(p.y);
    }
  }
  system_.emplace(sheet_equations(*shape_, middle_, length_), middle_.size() + 1);
}

std::vector<double> Wall::missed_by_samples(const Acting& acting, std::span<const double> gamma,
                                            std::size_t first, std::size_t last) const {
  const auto n = static_cast<std::ptrdiff_t>(panels());
  std::vector<double> missed(panels());
  for (std::size_t j = first; j < last; ++j) {
    const Vec2 at = acting.at(j);
    const WallPoint w = shape_->nearest(at);
    if (w.distance > near_panels * length_) continue;
    for_panels_near(w.arc, length_, n, [&](std::ptrdiff_t i) {
      const Vec2 p{sample_x_[2 * i], sample_y_[2 * i]},
          q{sample_x_[2 * i + 1], sample_y_[2 * i + 1]};
      const double sampled = 0.5 * dot(point_velocity(p, at) + point_velocity(q, at), tangent_[i]);
      const double exact = inverse_two_pi / length_ * angle(at, edge_[i], edge_[(i + 1) % n]);
      missed[i] += gamma[j] * (exact - sampled);
    });
  }
  return missed;
}

std::vector<double> Wall::slip(Vec2 stream, const Velocities& at_samples, const Acting& acting,
                               std::span<const double> gamma) const {
  const auto n = static_cast<std::ptrdiff_t>(panels());
  std::vector<double> slip(panels());
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const Vec2 far = 0.5 * (Vec2{at_samples.u[2 * i], at_samples.v[2 * i]} +
                            Vec2{at_samples.u[2 * i + 1], at_samples.v[2 * i + 1]});
    slip[i] = dot(stream + far, tangent_[i]);
  }
  // A fixed number of parts, summed in order: the same result for any number of threads.
  constexpr std::ptrdiff_t parts = 16;
  std::vector<std::vector<double>> missed(parts);
#pragma omp parallel for schedule(dynamic, 1)
  for (std::ptrdiff_t part = 0; part < parts; ++part) {
    const std::size_t size = gamma.size();
    missed[part] = missed_by_samples(acting, gamma, size * part / parts, size * (part + 1) / parts);
  }
  for (const auto& part : missed)
    for (std::ptrdiff_t i = 0; i < n; ++i) slip[i] += part[i];
  return slip;
}

std::vector<double> Wall::sheet(std::span<const double> slip, double total) const {
  std::vector<double> right(slip.begin(), slip.end());
  right.push_back(total);
  std::vector<double> gamma = system_->solve(right);
  gamma.pop_back();
  return gamma;
}

void Wall::add_velocity(std::span<const double> sheet, const Velocity& velocity,
                        tree::Points targets, Velocities& u) const {
  const auto n = static_cast<std::ptrdiff_t>(panels());
  std::vector<double> circulation(sheet.begin(), sheet.end());
  for (double& g : circulation) g *= length_;
  Velocities far(targets.size());
  velocity.upon({middle_x_, middle_y_, circulation, {}}, targets, far);
  const auto count = static_cast<std::ptrdiff_t>(targets.size());
#pragma omp parallel for schedule(dynamic, 512)
  for (std::ptrdiff_t t = 0; t < count; ++t) {
    const Vec2 at{targets.x[t], targets.y[t]};
    Vec2 sum{far.u[t], far.v[t]};
    const WallPoint w = shape_->nearest(at);
    if (std::abs(w.distance) < near_panels * length_)
      for_panels_near(w.arc, length_, n, [&](std::ptrdiff_t i) {
        const Vec2 exact = panel_velocity(at, edge_[i], edge_[(i + 1) % n]);
        sum = sum + sheet[i] * (exact - length_ * point_velocity(at, middle_[i]));
      });
    u.u[t] += sum.x;
    u.v[t] += sum.y;
  }
}

double Wall::area() const {
  double sum = 0;
  for (std::size_t i = 0; i < panels(); ++i)
    sum += 0.5 * length_ * (middle_[i].x * tangent_[i].y - middle_[i].y * tangent_[i].x);
  return sum;
}

Vec2 Wall::first_moment(std::span<const double> sheet) const {
  Vec2 sum;
  for (std::size_t i = 0; i < sheet.size(); ++i) sum = sum + (sheet[i] * length_) * middle_[i];
  return sum;
}

}  // namespace vortree::vortex
