#include "vortex/wall/wall.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>

#include "base/ordered_sum.hpp"
#include "body/outlines/shape_group.hpp"
#include "fmm/plan.hpp"
#include "tree/base/numbers_where.hpp"
#include "vortex/wall/disc_multipole.hpp"
#include "vortex/wall/panel_kernel.hpp"
#include "vortex/wall/tuning.hpp"

namespace vortree::vortex {
namespace {

const double gauss = 0.5 / std::sqrt(3.0);

/// The sheet's equations and, last, its circulations; their multipliers take up what a discrete
/// slip misses of being free of circulation.
std::vector<double> sheet_equations(const Wall& wall) {
  const std::size_t n = wall.panels(), all = n + wall.rings().size();
  std::vector<double> a(all * all);
  for (std::size_t r = 0; r < wall.rings().size(); ++r) {
    const Ring& ring = wall.rings()[r];
    for (std::size_t i = ring.first; i < ring.end(); ++i) {
      a[i * all + n + r] = 1;
      a[(n + r) * all + i] = wall.panel_length(i);
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::vector<double> k = wall.kernel(i);
    for (std::size_t j = 0; j < n; ++j)
      a[i * all + j] = (i == j ? 0.5 : 0.0) - panel::inverse_two_pi * wall.panel_length(j) * k[j];
  }
  return a;
}

std::shared_ptr<const body::Shape> together(const std::vector<WallBody>& bodies) {
  if (bodies.size() == 1) return bodies.front().shape;
  std::vector<std::shared_ptr<const body::Shape>> shapes;
  for (const WallBody& one : bodies) shapes.push_back(one.shape);
  return std::make_shared<body::ShapeGroup>(std::move(shapes));
}

}  // namespace

Wall::Wall(std::vector<WallBody> bodies) : shape_(together(bodies)) {
  double arc = 0;
  for (const WallBody& body : bodies) {
    if (body.panels < 8)
      throw std::invalid_argument(std::to_string(body.panels) + " panels; a wall needs at least 8");
    add_body(body, arc);
    arc += body.shape->perimeter();
  }
  system_.emplace(sheet_equations(*this), panels() + rings_.size());
}

void Wall::add_body(const WallBody& body, double arc) {
  const body::Shape& shape = *body.shape;
  const body::Grading grading = body.grading ? *body.grading : body::Grading(shape, body.panels);
  const Ring ring{panels(),    static_cast<std::size_t>(body.panels),
                  arc,         shape.perimeter() / body.panels,
                  body.centre, grading.even()};
  std::vector<double> ends;
  for (int i = 0; i < body.panels; ++i) {
    ends.push_back(grading.arc(i));
    edge_.push_back(shape.point(ends.back()));
    arc_.push_back(arc + grading.arc(i + 0.5));
    length_.push_back(grading.length(i + 0.5));
    middle_.push_back(shape.point(grading.arc(i + 0.5)));
    tangent_.push_back(shape.nearest(middle_.back()).tangent());
    middle_x_.push_back(middle_.back().x);
    middle_y_.push_back(middle_.back().y);
    for (double offset : {0.5 - gauss, 0.5 + gauss}) {
      const Vec2 p = shape.point(grading.arc(i + offset));
      sample_x_.push_back(p.x);
      sample_y_.push_back(p.y);
      sample_stretch_.push_back(grading.length(i + offset) / length_.back());
    }
  }
  rings_.push_back(ring);
  const PanelsOfBody own{
      ring.of(edge_),
      ring.of(middle_),
      ring.of(tangent_),
      {std::span(sample_x_).subspan(2 * ring.first), std::span(sample_y_).subspan(2 * ring.first)},
      std::span(sample_stretch_).subspan(2 * ring.first),
      ring.of(length_),
      ends};
  const NearPanels near(own);
  parts_.push_back({body.shape, near,
                    FarMoments(ring.of(edge_), ring.of(middle_), ring.of(length_), near.aside())});
}

std::size_t Wall::ring_of(std::size_t panel) const {
  std::size_t k = 0;
  while (panel >= rings_[k].end()) ++k;
  return k;
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
  for (std::size_t k = 0; k < near.size(); ++k) {
    for (std::size_t i = 0; i < near[k].size(); ++i) near[k][i] += other.near[k][i];
    for (std::size_t i = 0; i < moments[k].size(); ++i) moments[k][i] += other.moments[k][i];
  }
  return *this;
}

body::WallPoint Wall::nearest_on(std::size_t k, const body::WallPoint& known, Vec2 at,
                                 double reach) const {
  if (known.distance == INFINITY || ring_at(known.arc) != k)
    return wall_point_within(at, reach, parts_[k].shape.get());
  body::WallPoint on_body = known;
  on_body.arc -= rings_[k].arc;
  return on_body;
}

/// Exactly along the panels near it, or, if it reaches farther than these, along all.
void Wall::add_core(Vec2 at, const Deviator& deviator, const body::WallPoint& nearest, double gamma,
                    Missed& missed) const {
  const ThreePoints points(deviator, nearest);
  const std::size_t own = ring_at(nearest.arc);
  const double arc = nearest.arc - rings_[own].arc;
  const std::size_t panel = parts_[own].near.panel_at(arc);
  if (!parts_[own].far.serves(panel, std::hypot(nearest.distance, points.arm()))) {
    for (std::size_t k = 0; k < parts_.size(); ++k)
      parts_[k].near.add_aside_everywhere(at, points, gamma, missed.near[k]);
    return;
  }
  const NearPanels& near = parts_[own].near;
  near.add_aside(at, points, arc, gamma, missed.near[own]);
  parts_[own].far.gather(at, points, gamma, panel, missed.moments[own]);
}

Wall::Missed Wall::missed_by_samples(const FoldedBlobs& folded, std::span<const double> gamma,
                                     std::size_t first, std::size_t last) const {
  Missed missed;
  double widest = 0;
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    missed.near.push_back(parts_[k].near.wrapped_zeros());
    missed.moments.push_back(parts_[k].far.none());
    widest = std::max(widest, parts_[k].near.longest());
  }
  for (std::size_t j = first; j < last; ++j) {
    const Vec2 at = folded.at(j);
    const Deviator deviator = folded.deviator(j);
    const bool round = deviator == Deviator{};
    const body::WallPoint w =
        folded.wall.nearest(j, at, round ? exact_within * widest : INFINITY, shape_.get());
    if (w.distance == INFINITY) continue;
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      const NearPanels& near = parts_[k].near;
      const body::WallPoint on_body = nearest_on(k, w, at, exact_within * near.longest());
      if (near.close(on_body.distance, on_body.arc))
        near.add_missed(at, on_body.arc, gamma[j], missed.near[k]);
    }
    if (!round) add_core(at, deviator, w, gamma[j], missed);
  }
  for (std::size_t k = 0; k < parts_.size(); ++k)
    missed.near[k] = parts_[k].near.unwrapped(missed.near[k]);
  return missed;
}

Vec2 Wall::mean_of_samples(const Velocities& at_samples, std::size_t i) const {
  const auto at = [&](std::size_t k) {
    return sample_stretch_[k] * Vec2{at_samples.u[k], at_samples.v[k]};
  };
  return 0.5 * (at(2 * i) + at(2 * i + 1));
}

std::vector<double> Wall::slip(Vec2 stream, const Velocities& at_samples, const FoldedBlobs& folded,
                               std::span<const double> gamma) const {
  const auto n = static_cast<std::ptrdiff_t>(panels());
  std::vector<double> slip(panels());
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    slip[i] = dot(stream + mean_of_samples(at_samples, i), tangent_[i]);
  }
  const Missed missed = ordered_sum(gamma.size(), [&](std::size_t first, std::size_t last) {
    return missed_by_samples(folded, gamma, first, last);
  });
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    const std::span<double> own = rings_[k].of(slip);
    for (std::size_t i = 0; i < own.size(); ++i) own[i] += missed.near[k][i];
    parts_[k].far.add_slip(missed.moments[k], own);
    for (std::size_t other = 0; other < parts_.size(); ++other)
      if (other != k)
        parts_[k].far.add_slip_elsewhere(missed.moments[k], rings_[other].of(edge_),
                                         rings_[other].of(length_), rings_[other].of(slip));
  }
  return slip;
}

std::vector<double> Wall::sheet(std::span<const double> slip,
                                std::span<const double> totals) const {
  std::vector<double> right(slip.begin(), slip.end());
  right.insert(right.end(), totals.begin(), totals.end());
  std::vector<double> gamma = system_->solve(right);
  gamma.resize(panels());
  return gamma;
}

std::vector<double> Wall::sheet(std::span<const double> slip, double total) const {
  return sheet(slip, shared(total));
}

std::vector<double> Wall::shared(double total) const {
  if (rings_.size() == 1) return {total};
  std::vector<double> shares;
  for (const Part& part : parts_)
    shares.push_back(total * part.shape->perimeter() / shape_->perimeter());
  return shares;
}

void Wall::add_velocity_of_points(const Ring& ring, std::span<const double> sheet,
                                  const fmm::Options& sums, tree::Points targets,
                                  Velocities& u) const {
  const tree::Points middles{ring.of(middle_x_), ring.of(middle_y_)};
  std::vector<double> circulation;
  for (std::size_t i = ring.first; i < ring.end(); ++i)
    circulation.push_back(sheet[i] * length_[i]);
  const Disc disc(middles);
  const auto served = [&](std::uint32_t t) { return disc.serves({targets.x[t], targets.y[t]}); };
  const std::vector<std::uint32_t> far = tree::numbers_where(targets.size(), served),
                                   near = tree::numbers_where(targets.size(), std::not_fn(served));
  std::vector<double> x(near.size()), y(near.size());
  for (std::size_t k = 0; k < near.size(); ++k) {
    x[k] = targets.x[near[k]];
    y[k] = targets.y[near[k]];
  }
  if (!far.empty()) DiscMultipole(disc, middles, circulation).add_velocity(targets, far, u);
  Velocities upon_near(near.size());
  fmm::Options near_sums = sums;
  if (ring.panels <= panels_one_by_one) near_sums.method = fmm::SumMethod::direct;
  fmm::Plan({middles.x, middles.y, circulation, {}}, near_sums)
      .velocity(fmm::Targets{x, y, {}}, upon_near.u, upon_near.v);
  for (std::size_t k = 0; k < near.size(); ++k) {
    u.u[near[k]] += upon_near.u[k];
    u.v[near[k]] += upon_near.v[k];
  }
}

void Wall::each_near(std::size_t k, tree::Points targets, const WallPoints& found,
                     const auto& use) const {
  const NearPanels& near = parts_[k].near;
  const double farthest = exact_within * near.longest();
  const auto count = static_cast<std::ptrdiff_t>(targets.size());
#pragma omp parallel for schedule(dynamic, wall_points_a_turn)
  for (std::ptrdiff_t t = 0; t < count; ++t) {
    const Vec2 at{targets.x[t], targets.y[t]};
    const body::WallPoint w = nearest_on(k, found.known(t), at, farthest);
    if (near.close(std::abs(w.distance), w.arc)) use(t, at, w.arc);
  }
}

void Wall::add_velocity(std::span<const double> sheet, const fmm::Options& sums,
                        tree::Points targets, Velocities& u, const WallPoints& found) const {
  for (std::size_t k = 0; k < rings_.size(); ++k) {
    const NearPanels& near = parts_[k].near;
    const std::vector<double> wrapped = near.wrapped(rings_[k].of(sheet));
    add_velocity_of_points(rings_[k], sheet, sums, targets, u);
    each_near(k, targets, found, [&](std::ptrdiff_t t, Vec2 at, double arc) {
      const Vec2 sum = near.correction(at, arc, wrapped);
      u.u[t] += sum.x;
      u.v[t] += sum.y;
    });
  }
}

void Wall::add_stream_function(std::span<const double> sheet, const fmm::Options& sums,
                               tree::Points targets, std::span<double> psi) const {
  std::vector<double> circulation(sheet.begin(), sheet.end()), of_points(targets.size());
  for (std::size_t i = 0; i < panels(); ++i) circulation[i] *= length_[i];
  fmm::Plan({middle_x_, middle_y_, circulation, {}}, sums)
      .stream_function(fmm::Targets{targets.x, targets.y, {}}, of_points);
  for (std::size_t t = 0; t < psi.size(); ++t) psi[t] += of_points[t];
  for (std::size_t k = 0; k < rings_.size(); ++k) {
    const NearPanels& near = parts_[k].near;
    const std::vector<double> wrapped = near.wrapped(rings_[k].of(sheet));
    each_near(k, targets, WallPoints(), [&](std::ptrdiff_t t, Vec2 at, double arc) {
      psi[t] += near.stream_correction(at, arc, wrapped);
    });
  }
}

/// A vortex of strength q has the velocity q e x (x - x')/(2 pi r^2).
void Wall::add_dipoles(std::span<const double> x, std::span<const double> y,
                       const fmm::Options& sums, tree::Points targets,
                       std::span<double> potential) const {
  Velocities of_x(targets.size()), of_y(targets.size());
  for (const Ring& ring : rings_) {
    add_velocity_of_points(ring, x, sums, targets, of_x);
    add_velocity_of_points(ring, y, sums, targets, of_y);
  }
  for (std::size_t t = 0; t < potential.size(); ++t) potential[t] += of_x.v[t] - of_y.u[t];
  for (std::size_t k = 0; k < rings_.size(); ++k) {
    const NearPanels& near = parts_[k].near;
    const NearPanels::DipoleLayer layer = near.layer(rings_[k].of(x), rings_[k].of(y));
    each_near(k, targets, WallPoints(), [&](std::ptrdiff_t t, Vec2 at, double arc) {
      potential[t] += near.dipole_correction(at, arc, layer);
    });
  }
}

double Wall::area(std::size_t k) const {
  const Ring& ring = rings_[k];
  double sum = 0;
  for (std::size_t i = ring.first; i < ring.end(); ++i)
    sum += 0.5 * length_[i] * (middle_[i].x * tangent_[i].y - middle_[i].y * tangent_[i].x);
  return sum;
}

/// The divergence of x_k x is 3 x_k.
Vec2 Wall::area_moment(std::size_t k) const {
  const Ring& ring = rings_[k];
  Vec2 sum;
  for (std::size_t i = ring.first; i < ring.end(); ++i) {
    const double out = middle_[i].x * tangent_[i].y - middle_[i].y * tangent_[i].x;
    sum += (out * length_[i] / 3) * middle_[i];
  }
  return sum;
}

Vec2 Wall::first_moment(std::span<const double> sheet) const {
  Vec2 sum;
  for (std::size_t i = 0; i < panels(); ++i) sum = sum + (sheet[i] * length_[i]) * middle_[i];
  return sum;
}

}  // namespace vortree::vortex
