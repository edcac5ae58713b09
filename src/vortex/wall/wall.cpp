#include "vortex/wall/wall.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "base/ordered_sum.hpp"
#include "fmm/plan.hpp"
#include "vortex/wall/disc_multipole.hpp"
#include "vortex/wall/panel_kernel.hpp"
#include "vortex/wall/tuning.hpp"

namespace vortree::vortex {
namespace {

const double gauss = 0.5 / std::sqrt(3.0);

/// The sheet's equations and, last, its circulation; their multiplier takes up what a discrete slip
/// misses of being free of circulation.
std::vector<double> sheet_equations(const Wall& wall) {
  const std::size_t n = wall.panels();
  std::vector<double> a((n + 1) * (n + 1));
  for (std::size_t i = 0; i < n; ++i) {
    const std::vector<double> k = wall.kernel(i);
    double* row = &a[i * (n + 1)];
    for (std::size_t j = 0; j < n; ++j)
      row[j] = (i == j ? 0.5 : 0.0) - panel::inverse_two_pi * wall.panel_length() * k[j];
    row[n] = 1;
    a[n * (n + 1) + i] = wall.panel_length();
  }
  return a;
}

}  // namespace

Wall::Wall(std::shared_ptr<const body::Shape> shape, int panels) : shape_(std::move(shape)) {
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
  near_.emplace(edge_, middle_, tangent_, samples(), length_);
  far_.emplace(edge_, middle_, length_, near_->aside());
  system_.emplace(sheet_equations(*this), middle_.size() + 1);
}

std::vector<double> Wall::kernel(std::size_t i) const {
  const body::WallPoint at = shape_->nearest(middle_[i]);
  std::vector<double> k(panels());
  for (std::size_t j = 0; j < k.size(); ++j) {
    const Vec2 d = middle_[i] - middle_[j];
    k[j] = i == j ? at.curvature / 2 : dot(at.normal, d) / dot(d, d);
  }
  return k;
}

Wall::Missed& Wall::Missed::operator+=(const Missed& other) {
  for (std::size_t i = 0; i < near.size(); ++i) near[i] += other.near[i];
  for (std::size_t i = 0; i < moments.size(); ++i) moments[i] += other.moments[i];
  return *this;
}

/// Exactly along the panels near it, or, if it reaches farther than these, along all.
void Wall::add_core(Vec2 at, const Deviator& deviator, const body::WallPoint& nearest, double gamma,
                    Missed& missed) const {
  const ThreePoints points(deviator, nearest);
  if (std::hypot(nearest.distance, points.arm()) > gathered_within * length_)
    return near_->add_aside_everywhere(at, points, gamma, missed.near);
  near_->add_aside(at, points, nearest.arc, gamma, missed.near);
  far_->gather(at, points, gamma, near_->panel_at(nearest.arc), missed.moments);
}

Wall::Missed Wall::missed_by_samples(const FoldedBlobs& folded, std::span<const double> gamma,
                                     std::size_t first, std::size_t last) const {
  Missed missed{near_->wrapped_zeros(), far_->none()};
  for (std::size_t j = first; j < last; ++j) {
    const Vec2 at = folded.at(j);
    const Deviator deviator = folded.deviator(j);
    const bool round = deviator == Deviator{};
    const double reach = round ? exact_within * length_ : INFINITY;
    const body::WallPoint w = folded.wall.nearest(j, at, reach, shape_.get());
    if (w.distance <= exact_within * length_) near_->add_missed(at, w.arc, gamma[j], missed.near);
    if (!round) add_core(at, deviator, w, gamma[j], missed);
  }
  missed.near = near_->unwrapped(missed.near);
  return missed;
}

std::vector<double> Wall::slip(Vec2 stream, const Velocities& at_samples, const FoldedBlobs& folded,
                               std::span<const double> gamma) const {
  const auto n = static_cast<std::ptrdiff_t>(panels());
  std::vector<double> slip(panels());
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const Vec2 far = 0.5 * (Vec2{at_samples.u[2 * i], at_samples.v[2 * i]} +
                            Vec2{at_samples.u[2 * i + 1], at_samples.v[2 * i + 1]});
    slip[i] = dot(stream + far, tangent_[i]);
  }
  const Missed missed = ordered_sum(gamma.size(), [&](std::size_t first, std::size_t last) {
    return missed_by_samples(folded, gamma, first, last);
  });
  for (std::ptrdiff_t i = 0; i < n; ++i) slip[i] += missed.near[i];
  far_->add_slip(missed.moments, slip);
  return slip;
}

std::vector<double> Wall::sheet(std::span<const double> slip, double total) const {
  std::vector<double> right(slip.begin(), slip.end());
  right.push_back(total);
  std::vector<double> gamma = system_->solve(right);
  gamma.pop_back();
  return gamma;
}

void Wall::add_velocity_of_points(std::span<const double> sheet, const fmm::Options& sums,
                                  tree::Points targets, Velocities& u) const {
  std::vector<double> circulation(sheet.begin(), sheet.end());
  for (double& g : circulation) g *= length_;
  const Disc disc({middle_x_, middle_y_});
  std::vector<std::uint32_t> far, near;
  std::vector<double> x, y;
  for (std::uint32_t t = 0; t < targets.size(); ++t) {
    if (disc.serves({targets.x[t], targets.y[t]})) {
      far.push_back(t);
    } else {
      near.push_back(t);
      x.push_back(targets.x[t]);
      y.push_back(targets.y[t]);
    }
  }
  if (!far.empty())
    DiscMultipole(disc, {middle_x_, middle_y_}, circulation).add_velocity(targets, far, u);
  Velocities upon_near(near.size());
  fmm::Options near_sums = sums;
  if (panels() <= panels_one_by_one) near_sums.method = fmm::SumMethod::direct;
  fmm::Plan({middle_x_, middle_y_, circulation, {}}, near_sums)
      .velocity(fmm::Targets{x, y, {}}, upon_near.u, upon_near.v);
  for (std::size_t k = 0; k < near.size(); ++k) {
    u.u[near[k]] += upon_near.u[k];
    u.v[near[k]] += upon_near.v[k];
  }
}

void Wall::add_velocity(std::span<const double> sheet, const fmm::Options& sums,
                        tree::Points targets, Velocities& u, const WallPoints& found) const {
  add_velocity_of_points(sheet, sums, targets, u);
  const std::vector<double> wrapped = near_->wrapped(sheet);
  const auto count = static_cast<std::ptrdiff_t>(targets.size());
#pragma omp parallel for schedule(dynamic, wall_points_a_turn)
  for (std::ptrdiff_t t = 0; t < count; ++t) {
    const Vec2 at{targets.x[t], targets.y[t]};
    const body::WallPoint w = found.nearest(t, at, exact_within * length_, shape_.get());
    if (std::abs(w.distance) >= exact_within * length_) continue;
    const Vec2 sum = near_->correction(at, w.arc, wrapped);
    u.u[t] += sum.x;
    u.v[t] += sum.y;
  }
}

void Wall::add_stream_function(std::span<const double> sheet, const fmm::Options& sums,
                               tree::Points targets, std::span<double> psi) const {
  std::vector<double> circulation(sheet.begin(), sheet.end()), of_points(targets.size());
  for (double& g : circulation) g *= length_;
  fmm::Plan({middle_x_, middle_y_, circulation, {}}, sums)
      .stream_function(fmm::Targets{targets.x, targets.y, {}}, of_points);
  const std::vector<double> wrapped = near_->wrapped(sheet);
  const auto count = static_cast<std::ptrdiff_t>(targets.size());
#pragma omp parallel for schedule(dynamic, wall_points_a_turn)
  for (std::ptrdiff_t t = 0; t < count; ++t) {
    const Vec2 at{targets.x[t], targets.y[t]};
    const body::WallPoint w = WallPoints().nearest(t, at, exact_within * length_, shape_.get());
    psi[t] += of_points[t];
    if (std::abs(w.distance) < exact_within * length_)
      psi[t] += near_->stream_correction(at, w.arc, wrapped);
  }
}

/// A vortex of strength q has the velocity q e x (x - x')/(2 pi r^2).
void Wall::add_dipoles(std::span<const double> x, std::span<const double> y,
                       const fmm::Options& sums, tree::Points targets,
                       std::span<double> potential) const {
  Velocities of_x(targets.size()), of_y(targets.size());
  add_velocity_of_points(x, sums, targets, of_x);
  add_velocity_of_points(y, sums, targets, of_y);
  const NearPanels::DipoleLayer layer = near_->layer(x, y);
  const auto count = static_cast<std::ptrdiff_t>(targets.size());
#pragma omp parallel for schedule(dynamic, wall_points_a_turn)
  for (std::ptrdiff_t t = 0; t < count; ++t) {
    const Vec2 at{targets.x[t], targets.y[t]};
    const body::WallPoint w = WallPoints().nearest(t, at, exact_within * length_, shape_.get());
    potential[t] += of_x.v[t] - of_y.u[t];
    if (std::abs(w.distance) < exact_within * length_)
      potential[t] += near_->dipole_correction(at, w.arc, layer);
  }
}

double Wall::area() const {
  double sum = 0;
  for (std::size_t i = 0; i < panels(); ++i)
    sum += 0.5 * length_ * (middle_[i].x * tangent_[i].y - middle_[i].y * tangent_[i].x);
  return sum;
}

/// The divergence of x_k x is 3 x_k.
Vec2 Wall::area_moment() const {
  Vec2 sum;
  for (std::size_t i = 0; i < panels(); ++i) {
    const double out = middle_[i].x * tangent_[i].y - middle_[i].y * tangent_[i].x;
    sum += (out * length_ / 3) * middle_[i];
  }
  return sum;
}

Vec2 Wall::first_moment(std::span<const double> sheet) const {
  Vec2 sum;
  for (std::size_t i = 0; i < sheet.size(); ++i) sum = sum + (sheet[i] * length_) * middle_[i];
  return sum;
}

}  // namespace vortree::vortex
