#include "sph/boundary/biot_savart.hpp"

#include <algorithm>
#include <cmath>

#include "sph/boundary/tuning.hpp"

namespace vortree::sph {
namespace {

/// Nearer than `margin` to a side that the stream does not leave by.
bool beside_box(const OuterBox& box, Vec2 at, double margin, Vec2 stream) {
  const bool across = std::abs(stream.y) > std::abs(stream.x);
  const bool back = across ? stream.y < 0 : stream.x < 0, still = dot(stream, stream) == 0;
  const bool left = at.x < box.low.x + margin && (still || across || !back);
  const bool right = at.x > box.high.x - margin && (still || across || back);
  const bool bottom = at.y < box.low.y + margin && (still || !across || !back);
  const bool top = at.y > box.high.y - margin && (still || !across || back);
  return left || right || bottom || top;
}

}  // namespace

void BiotSavart::add(Vec2 at, Vec2 velocity, double gamma, double spacing) {
  all_.x.push_back(at.x), all_.y.push_back(at.y), all_.gamma.push_back(gamma);
  all_.sigma.push_back(core * spacing);
  all_.u.push_back(velocity.x), all_.v.push_back(velocity.y);
}

void BiotSavart::renew(const Cloud& cloud, const std::vector<Slopes>& slopes, Vec2 steady,
                       Vec2 stream) {
  for (std::vector<double>* column : {&all_.x, &all_.y, &all_.gamma, &all_.sigma, &all_.u, &all_.v})
    column->clear();
  for (const StandingBody& one : bodies_)
    if (one.spin != 0) add(one.centre, {}, one.circulation(), 0);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (cloud.kind[i] >= ParticleKind::outer || beside_box(box_, cloud.at(i), margin_, steady))
      continue;
    const double gamma = cloud.volume(i) * vorticity(slopes[i]);
    const double own = cloud.kind[i] == ParticleKind::wall ? gamma / 2 : gamma;
    if (std::abs(own) > faintest_) add(cloud.at(i), cloud.velocity(i), own, cloud.spacing[i]);
  }
  const std::vector<std::uint32_t> outlet = in_order(cloud, ParticleKind::outlet);
  const double spacing = outlet.empty() ? 0 : cloud.spacing[outlet.front()];
  for (std::size_t k = 0; k < left_x.size(); ++k)
    add({left_x[k], left_y[k]}, stream, left_gamma[k], spacing);
  for (std::size_t k = 0; k < leaving.size(); ++k)
    add(cloud.at(outlet[k]) + 0.5 * travelled, stream, leaving[k], spacing);
}

void BiotSavart::add_sheet(const Cloud& cloud) {
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (cloud.kind[i] != ParticleKind::wall) continue;
    const Vec2 n = cloud.normal(i),
               slip = cloud.velocity(i) - bodies_.wall_velocity(cloud.place[i], cloud.at(i));
    add(cloud.at(i), {}, dot(slip, {-n.y, n.x}) * cloud.spacing[i], cloud.spacing[i]);
  }
}

void BiotSavart::carry_out(const Cloud& cloud, const std::vector<Slopes>& slopes, Vec2 steady,
                           Vec2 drift, double dt) {
  for (double& x : left_x) x += drift.x;
  for (double& y : left_y) y += drift.y;
  const std::vector<std::uint32_t> outlet = in_order(cloud, ParticleKind::outlet);
  if (outlet.empty()) return;
  leaving.resize(outlet.size());
  for (std::size_t k = 0; k < outlet.size(); ++k) {
    const std::size_t i = outlet[k];
    const double out = -dot(cloud.velocity(i), cloud.normal(i));
    if (!beside_box(box_, cloud.at(i), margin_, steady))
      leaving[k] += dt * out * cloud.spacing[i] * vorticity(slopes[i]);
  }
  travelled += drift;
  const std::size_t first = outlet.front();
  if (-dot(travelled, cloud.normal(first)) > 0.5 * cloud.spacing[first]) release(cloud, outlet);
}

/// What has flowed out meanwhile stands in the middle of its way.
void BiotSavart::release(const Cloud& cloud, const std::vector<std::uint32_t>& outlet) {
  for (std::size_t k = 0; k < outlet.size(); ++k) {
    if (std::abs(leaving[k]) <= faintest_) continue;
    const Vec2 at = cloud.at(outlet[k]) + 0.5 * travelled;
    left_x.push_back(at.x), left_y.push_back(at.y), left_gamma.push_back(leaving[k]);
    leaving[k] = 0;
  }
  travelled = {};
}

void BiotSavart::velocity(const std::vector<double>& x, const std::vector<double>& y, Vec2 stream,
                          std::span<double> u, std::span<double> v) const {
  std::ranges::fill(u, stream.x), std::ranges::fill(v, stream.y);
  if (all_.x.empty() || x.empty()) return;
  plan(x.size(), {}).velocity_bare({x, y}, u, v);
  for (std::size_t k = 0; k < x.size(); ++k) u[k] += stream.x, v[k] += stream.y;
}

void BiotSavart::velocity_among(const std::vector<double>& x, const std::vector<double>& y,
                                std::span<double> u, std::span<double> v) const {
  std::ranges::fill(u, 0.0), std::ranges::fill(v, 0.0);
  if (all_.x.empty() || x.empty()) return;
  plan(x.size(), all_.sigma).velocity({x, y, {}}, u, v);
}

fmm::Plan BiotSavart::plan(std::size_t targets, std::span<const double> cores) const {
  const bool few = all_.x.size() * targets < worth_a_tree;
  return {{all_.x, all_.y, all_.gamma, cores},
          {.tolerance = far_field_tolerance,
           .method = few ? fmm::SumMethod::direct : fmm::SumMethod::fmm}};
}

double BiotSavart::circulation() const {
  double sum = 0;
  for (const double gamma : all_.gamma) sum += gamma;
  return sum;
}

double BiotSavart::second_moment() const {
  double sum = 0;
  for (std::size_t k = 0; k < all_.x.size(); ++k)
    sum += all_.gamma[k] * (all_.x[k] * all_.x[k] + all_.y[k] * all_.y[k]);
  return sum;
}

Vec2 BiotSavart::impulse() const {
  Vec2 sum{};
  for (std::size_t k = 0; k < all_.x.size(); ++k)
    sum += all_.gamma[k] * Vec2{all_.y[k], -all_.x[k]};
  return sum;
}

}  // namespace vortree::sph
