#include "vortex/choice/cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "body/extent.hpp"
#include "flow/initial/widths.hpp"
#include "flow/solver.hpp"
#include "flow/steps.hpp"
#include "vortex/choice/scales.hpp"

namespace vortree::vortex {
namespace {

// Measured on one thread: 144 000 to 242 000 blobs took 860 bytes each, flows of thousands of blobs
// 0.1 to 0.4 million blobs a second and evaluation (two a step, of rk4 four), a picture's point
// five columns and a place in a tree; Eigen's factors of a matrix beside the matrix itself some 3e9
// operations a second.
constexpr double bytes_a_blob = 1000, bytes_a_point = 150, blobs_a_second = 2e5,
                 operations_a_second = 3e9, points_a_second = 3e5, seconds_a_step = 1e-3;

/// How many a blob becomes where nothing merges.
double multiplied_in(const VortexCase& scene, double time) {
  if (!makes_children(scene) || scene.merging.tolerance > 0) return 1;
  return std::pow(scene.splitting.children, std::floor(generations(scene, time)));
}

double free_blobs(const VortexCase& scene) {
  const flow::InitialSettings& i = *scene.initial;
  const double start = lattice_blobs(i, scene.cores.sigma_0),
               most2 = scene.cores.sigma_max * scene.cores.sigma_max;
  if (!spreads_cores(scene)) return start;
  if (scene.merging.tolerance == 0 && makes_children(scene))
    return start * multiplied_in(scene, scene.time.end);
  const auto [along, across] = flow::half_widths(i);
  const auto vortices = static_cast<double>(flow::vortices(i));
  const double spread = 4 * scene.flow.nu * scene.time.end;
  const double area = std::numbers::pi *
                      std::sqrt((along * along + spread) * (across * across + spread)) *
                      -std::log(i.faintest);
  return std::max(start, crowding(scene) * vortices * area / most2);
}

/// Boundary layer and wake, cut off by the box, thinned by coarsening.
double wake_area(const VortexCase& scene) {
  const double layer = 4 * std::sqrt(scene.flow.nu * scene.time.end);
  const double way = flow::fastest_of(scene) * scene.time.end,
               from = scene.cores.coarsen_from.value_or(way);
  const double beyond = way > from ? 2 * from * (1 - std::sqrt(from / way)) : 0;
  double area = 0;
  for (const body::BodySettings& one : flow::every_body(scene)) {
    const double around = layer * (body::perimeter_of(one) + std::numbers::pi * layer);
    area += around + (body::length_of(one) + layer) * (std::min(way, from) + beyond);
  }
  if (!scene.merging.box) return area;
  const auto [x0, y0, x1, y1] = *scene.merging.box;
  return std::min(area, (x1 - x0) * (y1 - y0));
}

double wall_blobs(const VortexCase& scene, double steps) {
  const double released = panels_of(scene) * (steps + 8);
  const bool merges = scene.flow.nu > 0 && scene.merging.tolerance > 0;
  if (!merges) return released * multiplied_in(scene, scene.time.end);
  const double most2 = scene.cores.sigma_max * scene.cores.sigma_max;
  return panels_of(scene) + crowding(scene) * 1.5 * wake_area(scene) / most2;
}

double picture_points(const flow::OutputSettings& output) {
  if (!output.pictures()) return 0;
  const auto [x0, y0, x1, y1] = *output.window;
  const double h = *output.field_spacing;
  return ((x1 - x0) / h + 1) * ((y1 - y0) / h + 1);
}

std::string duration(double seconds) {
  const double hours = seconds / 3600;
  if (hours < 2) return fmt::format("{:.0f} minutes", seconds / 60);
  if (hours < 48) return fmt::format("{:.0f} hours", hours);
  return hours < 24 * 700 ? fmt::format("{:.0f} days", hours / 24)
                          : fmt::format("{:.2g} years", hours / 24 / 365);
}

std::string size(double bytes) {
  return bytes < 1e9 ? fmt::format("{:.0f} MB", bytes / 1e6)
                     : fmt::format("{:.3g} GB", bytes / 1e9);
}

}  // namespace

std::size_t blobs_in(double bytes) {
  return static_cast<std::size_t>(std::min(bytes / bytes_a_blob, 1e15));
}

Cost cost_of(const VortexCase& scene) {
  Cost c{.steps = scene.time.end / scene.time.dt};
  const double panels = panels_of(scene);
  const double start = scene.initial ? lattice_blobs(*scene.initial, scene.cores.sigma_0) : 0;
  c.blobs = scene.body ? wall_blobs(scene, c.steps) + start : free_blobs(scene);
  // The matrix is there twice while it is cut into factors.
  c.wall_bytes = 2 * 8 * (panels + 1) * (panels + 1);
  c.bytes = bytes_a_blob * c.blobs + c.wall_bytes + bytes_a_point * picture_points(scene.output);
  c.setup = 2.0 / 3 * panels * panels * panels / operations_a_second;
  const double sums = scene.time.scheme == flow::Scheme::rk4 ? 2 : 1, mean = (start + c.blobs) / 2;
  const bool direct = scene.velocity.method == fmm::SumMethod::direct;
  const double velocities = direct ? 10 * mean * mean / operations_a_second : mean / blobs_a_second;
  const double solves = 4 * panels * panels / operations_a_second;
  const double pictures =
      static_cast<double>(flow::picture_times(scene.output, scene.time.end).size()) *
      picture_points(scene.output) / points_a_second;
  // The wall of bodies that move against each other is made anew, for middle and end of a step.
  const bool anew = std::ranges::any_of(
      flow::bodies_of(scene), [](const body::Body& one) { return one.own.course.moves(); });
  const double walls = anew ? sums * 2 * c.setup : 0;
  c.seconds =
      c.setup + pictures + c.steps * (seconds_a_step + walls + sums * (velocities + solves));
  return c;
}

flow::Warnings costly(const VortexCase& scene, double memory) {
  flow::Warnings list;
  const Cost c = cost_of(scene);
  if (c.setup > 60)
    list.push_back(fmt::format(
        "body.panels = {}: the wall's matrix takes {} and some {} before the first step",
        panels_of(scene), size(c.wall_bytes), duration(c.setup)));
  if (c.seconds > 3600)
    list.push_back(fmt::format("the run will take some {}: {:.2g} steps, up to {:.2g} blobs",
                               duration(c.seconds), c.steps, c.blobs));
  if (c.bytes > memory / 2)
    list.push_back(fmt::format("the run will need some {} of the {} there are: {:.2g} blobs",
                               size(c.bytes), size(memory), c.blobs));
  return list;
}

void refuse_beyond(const VortexCase& scene, double memory) {
  const Cost c = cost_of(scene);
  const auto refuse = [&](const char* key, const std::string& words) {
    throw Refused(key, fmt::format("{}, more than the {} of this machine", words, size(memory)));
  };
  if (c.wall_bytes > memory)
    refuse("body.panels", fmt::format("body.panels is {}; the wall's matrix would take {}",
                                      panels_of(scene), size(c.wall_bytes)));
  if (const double most = std::min<double>(blobs_in(memory), flow::most_particles);
      scene.initial && lattice_blobs(*scene.initial, scene.cores.sigma_0) > most)
    throw Refused(
        "initial.spacing",
        fmt::format("initial.spacing {} and cores.sigma_0 {} cut the vortex into {:.3g} blobs; "
                    "this machine holds {:.2g}",
                    scene.initial->spacing, scene.cores.sigma_0,
                    lattice_blobs(*scene.initial, scene.cores.sigma_0), most));
  if (const double picture = bytes_a_point * picture_points(scene.output); picture > memory)
    refuse("output.field_spacing",
           fmt::format("output.field_spacing {} makes pictures of {:.2g} points and {}",
                       *scene.output.field_spacing, picture_points(scene.output), size(picture)));
  // What grows on the way is known to a factor of three.
  if (c.bytes > 3 * memory)
    refuse("cores.sigma_max",
           fmt::format("cores.sigma_max {}, merging.tolerance {} and time.end {} make some {:.2g} "
                       "blobs and need some {}",
                       scene.cores.sigma_max, scene.merging.tolerance, scene.time.end, c.blobs,
                       size(c.bytes)));
}

}  // namespace vortree::vortex
