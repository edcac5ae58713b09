#include "sph/choice/warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/rounded.hpp"
#include "body/extent.hpp"
#include "body/shapes/shapes.hpp"
#include "flow/initial/widths.hpp"
#include "sph/choice/cost.hpp"
#include "sph/setup.hpp"

namespace vortree::sph {
namespace {

/// By more than what six digits do not show.
bool exceeds(double spacing, double widest) {
  return spacing > widest * (1 + 1e-5);
}

/// The least of all bodies.
double least_of(const SphCase& scene, const auto& of) {
  double least = INFINITY;
  for (const body::BodySettings& one : flow::every_body(scene)) least = std::min(least, of(one));
  return least;
}

/// A layer of the thickness D/sqrt(Re) wants three spacings.
void doubt_spacing(flow::Warnings& list, const SphCase& scene) {
  const double length = lengths_of(scene).shortest;
  const double reynolds = flow::fastest_of(scene) * length / scene.flow.nu;
  const double widest = length / std::sqrt(reynolds) / 3;
  if (exceeds(scene.sph.spacing, widest))
    list.push_back(fmt::format(
        "sph.spacing = {:.6g}: at Re = {:.4g} the layer beside the body is {:.2g} thick; forces "
        "want {} or less",
        scene.sph.spacing, reynolds, 3 * widest, rounded_down(widest, 2)));
}

/// Less than two rows of neighbors fit beside each other in the body.
void doubt_thickness(flow::Warnings& list, const SphCase& scene) {
  const double thickness = least_of(scene, thickness_of), widest = thickness / 4;
  if (exceeds(scene.sph.spacing, widest))
    list.push_back(
        fmt::format("sph.spacing = {:.6g}: the body is {:.2g} thick in the mean, and particles on "
                    "both sides of "
                    "it would feel each other; {} or less is wanted",
                    scene.sph.spacing, thickness, rounded_down(widest, 2)));
}

/// Flow between two walls wants ten particles across.
void doubt_gap(flow::Warnings& list, const SphCase& scene) {
  const double gap = gap_of(scene), widest = gap / 10;
  if (exceeds(scene.sph.spacing, widest))
    list.push_back(fmt::format(
        "sph.spacing = {:.6g}: the gap of {:.2g} between two bodies is only {:.2g} particles wide; "
        "{} or less is wanted",
        scene.sph.spacing, gap, gap / scene.sph.spacing, rounded_down(widest, 2)));
}

void doubt_motion(flow::Warnings& list, const SphSettings& own) {
  if (own.shift < 4)
    list.push_back(fmt::format(
        "sph.shift = {:.3g}: particles fall into disorder where fluid is strained; 6 holds",
        own.shift));
  if (own.courant > 0.5)
    list.push_back(fmt::format(
        "sph.courant = {:.3g}: particles pass each other in one step; 0.3 holds", own.courant));
}

/// A step that is written instead of chosen by the Courant number.
void doubt_step(flow::Warnings& list, const SphCase& scene, double speed) {
  const double finest = finest_of(scene.sph), moved = scene.time.dt * speed / finest;
  if (moved > 0.6 && moved > 1.5 * scene.sph.courant)
    list.push_back(fmt::format(
        "time.dt = {:.3g}: fluid moves {:.2g} of the finest spacings in a step; {} is what "
        "sph.courant = {:.3g} asks for",
        scene.time.dt, moved, rounded_down(scene.sph.courant * finest / speed, 2),
        scene.sph.courant));
}

/// A particle as wide as that sees the body as one of its neighbors.
void doubt_levels(flow::Warnings& list, const SphCase& scene) {
  const double length = lengths_of(scene).shortest, coarsest = coarsest_of(scene.sph);
  if (scene.sph.levels > 1 && coarsest > length / 2)
    list.push_back(
        fmt::format("sph.levels = {}: the widest particles are {:.3g} apart, more than half the "
                    "length of the body, {:.3g}; a fifth is wanted",
                    scene.sph.levels, coarsest, length));
}

/// Measured at Re = 1000: with 8 particles a wavelength the flow falls into other vortices.
void doubt_wavelength(flow::Warnings& list, const SphCase& scene, double wavelength) {
  const double coarsest = coarsest_of(scene.sph), widest = wavelength / 12;
  if (exceeds(coarsest, widest))
    list.push_back(
        fmt::format("sph.spacing: particles are {:.6g} apart, hardly {:.2g} in a "
                    "wavelength; {} or less is wanted",
                    coarsest, wavelength / coarsest, rounded_down(widest, 2)));
}

/// From a body's centre to the nearest side of the box.
double way_to_box(const body::BodySettings& body, const SphSettings& own) {
  const auto [x, y] = body.centre;
  const auto [x0, y0, x1, y1] = *own.box;
  return std::min({x - x0, x1 - x, y - y0, y1 - y});
}

void doubt_box(flow::Warnings& list, const SphCase& scene) {
  const double room = least_of(scene, [&](const body::BodySettings& one) {
    return way_to_box(one, scene.sph) / extent_of(one);
  });
  const double wanted = scene.sph.outside == Outside::free ? 3 : 10;
  if (room < wanted)
    list.push_back(fmt::format(
        "sph.box is {:.2g} lengths of the body away from its centre; forces want {} or more", room,
        wanted));
}

/// Vorticity that comes to a side by which the stream does not leave is lost to the far field.
void doubt_sides(flow::Warnings& list, const SphCase& scene) {
  const auto [x0, y0, x1, y1] = *scene.sph.box;
  const auto [u, v] = scene.flow.stream;
  const double end = scene.time.end, spread = std::sqrt(4 * scene.flow.nu * end);
  const double near = 0.85 * least_of(scene, [&](const body::BodySettings& one) {
                        return way_to_box(one, scene.sph);
                      });
  if (spread > near)
    list.push_back(
        fmt::format("time.end = {:.3g}: vorticity spreads over {:.2g} by then, and beside the "
                    "sides of sph.box, "
                    "from {:.2g} on, it does not count; a larger box is wanted",
                    end, spread, near));
  const bool across = std::abs(v) > std::abs(u);
  const double way = end * std::min(std::abs(u), std::abs(v));
  const double room = least_of(scene, [&](const body::BodySettings& one) {
    const auto [x, y] = one.centre;
    return across ? std::min(x - x0, x1 - x) : std::min(y - y0, y1 - y);
  });
  if (way > 0.85 * room)
    list.push_back(
        fmt::format("flow.stream = [{:.3g}, {:.3g}]: by time.end = {:.3g} the wake comes to a side "
                    "of sph.box that "
                    "lets nothing out; only the side which the stream meets first does",
                    u, v, end));
}

/// A search of all pairs takes as long as the rest of a step at some thousand particles.
void doubt_neighbors(flow::Warnings& list, const SphCase& scene) {
  const double particles = expected_particles(scene);
  if (!neighbors::maker_of(scene.neighbors.method).quadratic || particles < 5000) return;
  list.push_back(fmt::format(
      "neighbors.method = \"{}\": the time of a step grows with the square of the {:.2g} "
      "particles; \"qcg\" finds the same neighbors",
      word(scene.neighbors.method), particles));
}

/// A region that is no finer than all, or where no particles are.
void doubt_region(flow::Warnings& list, const SphSettings& own, std::size_t k) {
  const auto& [centre, half_axes, angle, spacing] = own.regions[k];
  if (const double coarsest = coarsest_of(own); spacing > 0.99 * coarsest)
    list.push_back(fmt::format(
        "sph.region[{}].spacing = {:.6g} has no effect: with sph.levels = {} particles are at most "
        "{:.6g} apart",
        k, spacing, own.levels, coarsest));
  const auto [x0, y0, x1, y1] = *own.box;
  const auto [x, y] = centre;
  if (own.outside != Outside::periodic && (x < x0 || x > x1 || y < y0 || y > y1))
    list.push_back(
        fmt::format("sph.region[{}].centre = [{:.4g}, {:.4g}] lies outside of sph.box", k, x, y));
}

/// What asks for finer particles where all are alike, or where none are.
void doubt_wishes(flow::Warnings& list, const SphSettings& own) {
  if (own.levels == 1 && own.vorticity)
    list.push_back(
        "sph.vorticity has no effect with sph.levels = 1, where all particles are alike");
  for (std::size_t k = 0; k < own.regions.size(); ++k) doubt_region(list, own, k);
}

/// Particles beside a vortex tell little of it if it is thinner than two of them.
void doubt_initial(flow::Warnings& list, const SphCase& scene) {
  const auto [x, y] = scene.initial->centre;
  const WantedSpacing wanted = wanted_of(scene.sph, bodies_of(scene).shape(),
                                         {scene.body->centre[0], scene.body->centre[1]});
  const double spacing = wanted.at({x - scene.body->centre[0], y - scene.body->centre[1]});
  const double width = flow::least_width(*scene.initial);
  if (width < 2 * spacing)
    list.push_back(fmt::format(
        "initial.core: the vortex is {:.3g} wide where particles are {:.3g} apart; two of them at "
        "least are wanted",
        width, spacing));
}

}  // namespace

flow::Warnings warnings(const SphCase& scene) {
  flow::Warnings list;
  if (scene.body) doubt_spacing(list, scene), doubt_thickness(list, scene), doubt_gap(list, scene);
  doubt_motion(list, scene.sph);
  const auto periodic = flow::periodic_flow_of(scene);
  doubt_step(list, scene, periodic ? periodic->speed : flow::fastest_of(scene));
  if (scene.body) doubt_levels(list, scene), doubt_box(list, scene), doubt_sides(list, scene);
  if (periodic) doubt_wavelength(list, scene, periodic->wavelength);
  doubt_neighbors(list, scene);
  doubt_wishes(list, scene.sph);
  if (scene.initial && scene.body) doubt_initial(list, scene);
  return list;
}

}  // namespace vortree::sph
