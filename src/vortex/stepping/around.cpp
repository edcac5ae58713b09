#include "vortex/stepping/around.hpp"

#include <numeric>

#include "base/ordered_sum.hpp"

namespace vortree::vortex {

Around::Around(const Problem& p, double time) : stream(p.flow.stream_at(time)) {
  for (const body::Motion& one : p.flow.own) velocities.push_back(one.at(time).velocity);
  for (std::size_t k = 0; k < p.turning.size(); ++k) rates.push_back(p.flow.rate(k, time));
}

double Around::circulation_of_bodies(const Problem& p) const {
  double sum = 0;
  for (std::size_t k = 0; k < rates.size(); ++k) sum += rates[k] * p.turning[k].circulation;
  return sum;
}

void add(std::vector<double>& sum, double weight, std::span<const double> of) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weight * of[i];
}

void add_stream(Velocities& u, Vec2 stream) {
  for (double& a : u.u) a += stream.x;
  for (double& a : u.v) a += stream.y;
}

Blobs felt(const Problem& p) {
  return p.box ? felt(p.drifting, *p.box) : Blobs{};
}

void append(Blobs& blobs, const Blobs& more) {
  for (std::size_t i = 0; i < more.size(); ++i)
    blobs.append(more.centre(i), more.gamma[i], more.core(i));
}

Blobs with_drifting(const Blobs& blobs, const Problem& p) {
  Blobs all = blobs;
  append(all, felt(p));
  return all;
}

fmm::Sources as_sources(const Blobs& blobs, const FoldedBlobs& at) {
  return {at.x, at.y, blobs.gamma, at.sigma};
}

fmm::Options at_points(fmm::Options sums) {
  sums.cores = fmm::Cores::source;
  return sums;
}

std::vector<double> with_turning(std::vector<double> sheet, const Problem& p,
                                 const Around& around) {
  for (std::size_t k = 0; k < p.turning.size(); ++k)
    add(sheet, around.rates[k], p.turning[k].sheet);
  return sheet;
}

namespace {

double total(std::span<const double> gamma) {
  return ordered_sum(gamma.size(), [&](std::size_t first, std::size_t last) {
    return std::reduce(gamma.begin() + first, gamma.begin() + last);
  });
}

/// The slip at the wall of all that moves fluid but the sheet.
std::vector<double> slip_of(const Blobs& blobs, const FoldedBlobs& at, const Velocities& at_samples,
                            const Problem& p, const Around& around) {
  std::vector<double> slip = p.wall->slip(around.stream, at_samples, at, blobs.gamma);
  for (std::size_t k = 0; k < p.turning.size(); ++k) add(slip, around.rates[k], p.turning[k].slip);
  for (std::size_t k = 0; k < around.velocities.size(); ++k) {
    const Ring& ring = p.wall->rings()[k];
    const Vec2 wall = around.velocities[k];
    for (std::size_t i = ring.first; i < ring.end(); ++i) slip[i] -= dot(wall, p.wall->tangent(i));
  }
  return slip;
}

/// Of all sheets, those that leave no circulation in fluid and bodies together: each body's own is
/// that of its spin-up since the step began, or the start at once; what is missing besides, since
/// faint blobs are let go or vorticity was there from the start, belongs to all. `all` has blobs
/// that drift, too.
std::vector<double> sheet_circulations(const Blobs& all, const Problem& p, const Around& around,
                                       bool at_once) {
  double missing = -total(all.gamma) - (p.outflow.gamma - total(felt(p).gamma)) -
                   around.circulation_of_bodies(p);
  if (p.wall->rings().size() == 1 || p.turning.empty()) return p.wall->shared(missing);
  std::vector<double> own;
  for (std::size_t k = 0; k < p.turning.size(); ++k) {
    const double before = at_once ? 0 : p.flow.rate(k, p.time);
    own.push_back((before - around.rates[k]) * p.turning[k].circulation);
    missing -= own.back();
  }
  add(own, 1, p.wall->shared(missing));
  return own;
}

}  // namespace

Velocities advecting_velocity(const Blobs& blobs, const FoldedBlobs& at, const Problem& p,
                              double time, Gradients* gradients) {
  const Around around(p, time);
  Velocities u(blobs.size());
  Velocities at_samples(p.wall ? 2 * p.wall->panels() : 0);
  FoldedBlobs advecting = at;
  if (p.advecting_cores != 1)
    for (double& sigma : advecting.sigma) sigma *= p.advecting_cores;
  const fmm::Sources sources = as_sources(blobs, advecting);
  const tree::Points samples = p.wall ? p.wall->samples() : tree::Points{};
  const fmm::Plan plan(sources, p.sums);
  if (gradients) {
    *gradients = Gradients(blobs.size());
    plan.velocity_and_gradient(u.u, u.v, gradients->ux, gradients->uy, gradients->vx);
  } else {
    plan.velocity(u.u, u.v);
  }
  plan.velocity_bare(samples, at_samples.u, at_samples.v);
  add_stream(u, around.stream);
  if (p.wall) {
    const auto slip = slip_of(blobs, at, at_samples, p, around);
    const auto sheet = p.wall->sheet(slip, sheet_circulations(blobs, p, around, false));
    p.wall->add_velocity(with_turning(sheet, p, around), at_points(p.sums), {at.x, at.y}, u,
                         at.wall);
  }
  return u;
}

AtRest with_sheet(tree::Points points, const Blobs& blobs, const FoldedBlobs& at, const Problem& p,
                  double time, bool at_once) {
  const Around around(p, time);
  AtRest result{{}, {}, Velocities(points.size())};
  Velocities at_samples(2 * p.wall->panels());
  const fmm::Plan plan(as_sources(blobs, at), at_points(p.sums));
  plan.velocity_bare(p.wall->samples(), at_samples.u, at_samples.v);
  plan.velocity(fmm::Targets{points.x, points.y, {}}, result.u.u, result.u.v);
  result.slip = slip_of(blobs, at, at_samples, p, around);
  result.sheet = p.wall->sheet(result.slip, sheet_circulations(blobs, p, around, at_once));
  add_stream(result.u, around.stream);
  p.wall->add_velocity(with_turning(result.sheet, p, around), at_points(p.sums), points, result.u);
  return result;
}

}  // namespace vortree::vortex
