#include "io/scene/sense.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/scene/scales.hpp"
#include "io/scene/schema.hpp"

namespace vortree::io {
namespace {

constexpr double largest = 1e30, least = 1e-30;

/// Of the body's length. A blob is released as long as a panel and as thick as a core, and its
/// covariance keeps both where their squares are less than 1e16 apart.
constexpr double thinnest_core = 1e-6;

void hold_size(const Document& document, std::string_view name, double value) {
  const double size = std::abs(value);
  if (size == 0 || (size >= least && size <= largest)) return;
  document.refuse(name,
                  fmt::format("{} is {}; numbers of a size within {:.0e} .. {:.0e} are computed "
                              "with: other units of length and time bring it there",
                              name, value, least, largest));
}

/// The real numbers that a key has.
std::span<const double> numbers(const auto&) {
  return {};
}
std::span<const double> numbers(double* value) {
  return {value, 1};
}
std::span<const double> numbers(std::vector<double>* values) {
  return *values;
}
template <std::size_t n>
std::span<const double> numbers(std::array<double, n>* values) {
  return *values;
}
template <class T>
std::span<const double> numbers(std::optional<T>* value) {
  return *value ? numbers(&**value) : std::span<const double>{};
}

/// Refuses numbers out of proportion.
void hold_sizes(const Document& document, std::string_view name, const Key& key) {
  const auto real = std::visit([](const auto& target) { return numbers(target); }, key.target);
  for (const double value : real) hold_size(document, name, value);
}

void hold_sizes(const Document& document, Scene scene) {
  for (const Key& key : keys(scene)) hold_sizes(document, key.name, key);
  for (const SceneTable& table : tables(scene)) {
    if (table.name == "check" || table.name == "output") continue;  // nothing is computed with
    if (!table.present()) continue;
    for (const Key& key : table.keys())
      hold_sizes(document, fmt::format("{}.{}", table.name, key.name), key);
  }
}

Vec2 seen_from(const Vec2& at, const Vec2& from) {
  return {at[0] - from[0], at[1] - from[1]};
}

void hold_pair(const Document& document, const vortex::InitialSettings& initial, double sigma_0) {
  if (!initial.separation || sigma_0 == 0) return;
  const double apart = *initial.separation;
  if (apart < sigma_0)
    document.refuse("initial.separation",
                    fmt::format("initial.separation is {}; two vortices are at least a core, "
                                "cores.sigma_0 = {}, apart",
                                apart, sigma_0));
  if (apart > 1e5 * sigma_0)
    document.refuse("initial.separation",
                    fmt::format("initial.separation is {}; vortices of cores.sigma_0 = {} can be "
                                "{} apart at most",
                                apart, sigma_0, 1e5 * sigma_0));
}

void hold_initial(const Document& document, const Scene& scene) {
  const vortex::InitialSettings& initial = *scene.initial;
  if (initial.circulation == 0)
    document.refuse("initial.circulation",
                    "initial.circulation is 0; there would be no vorticity to follow");
  if (initial.spacing > 3)
    document.refuse("initial.spacing",
                    fmt::format("initial.spacing is {}; blobs more than 3 cores apart make no "
                                "vortex; 1 is right",
                                initial.spacing));
}

void hold_distance(const Document& document, const Scene& scene) {
  const auto [x, y] = seen_from(scene.initial->centre, scene.body->centre);
  const double most = 1e5 * scene.cores.sigma_0;
  if (std::hypot(x, y) > most)
    document.refuse("initial.centre",
                    fmt::format("initial.centre is {} away from body.centre; blobs of "
                                "cores.sigma_0 = {} can be {} away at most",
                                std::hypot(x, y), scene.cores.sigma_0, most));
}

void hold_cores(const Document& document, const Scene& scene) {
  const double half = length_of(*scene.body) / 2;
  for (const auto& [key, core] : {std::pair{"cores.sigma_0", scene.cores.sigma_0},
                                  std::pair{"cores.sigma_max", scene.cores.sigma_max}})
    if (core > half)
      document.refuse(key, fmt::format("{} is {}; cores wider than half the body's length, {}, "
                                       "know nothing of it",
                                       key, core, half));
  if (const double least = thinnest_core * 2 * half; scene.cores.sigma_0 < least)
    document.refuse("cores.sigma_0",
                    fmt::format("cores.sigma_0 is {}; cores thinner than {:.0e} of the body's "
                                "length, {:.3g}, are lost beside panels",
                                scene.cores.sigma_0, thinnest_core, least));
}

void hold_steps(const Document& document, const Scene& scene) {
  const double dt = scene.time.dt;
  if (scene.plunge && dt * scene.plunge->frequency > 0.25)
    document.refuse("plunge.frequency",
                    fmt::format("plunge.frequency is {}; a period of it has {:.2g} steps of "
                                "time.dt = {}; {:.2g} gives it 100",
                                scene.plunge->frequency, 1 / (scene.plunge->frequency * dt), dt,
                                0.01 / scene.plunge->frequency));
  if (const double core = scene.cores.sigma_0;
      scene.diffusion.kind == vortex::Diffusion::particle_exchange &&
      scene.flow.nu * dt > 0.5 * core * core)
    document.refuse("diffusion.kind",
                    fmt::format("diffusion.kind is \"particle_exchange\"; that is unstable for "
                                "time.dt = {}, which may be sigma_0^2/(2 nu) = {:.3g} at most",
                                dt, 0.5 * core * core / scene.flow.nu));
  constexpr double most_turn = 100, good_turn = 0.5;
  if (const double turn = std::max(turn_at_wall(scene), turn_of_vortex(scene)); turn > most_turn)
    document.refuse("time.dt",
                    fmt::format("time.dt is {}; vorticity would turn by {:.3g} rad a step; {:.2g} "
                                "lets it turn by {}",
                                dt, turn, dt * good_turn / turn, good_turn));
}

void hold_tips(const Document& document, const body::BodySettings& body) {
  const double panel = perimeter_of(body) / body.panels, tip = tip_radius(body);
  if (panel <= blind_at_tip * tip) return;
  document.refuse(
      "body.panels",
      fmt::format("body.panels is {}; panels of {:.3g} step over the body's tips of radius {:.3g}; "
                  "at least {:.0f} see them, {:.0f} resolve them",
                  body.panels, panel, tip, std::ceil(perimeter_of(body) / (blind_at_tip * tip)),
                  std::ceil(perimeter_of(body) / (panel_at_tip * tip))));
}

/// merging.box must hold what lies within `half` of the centre.
void hold_box(const Document& document, const std::array<double, 4>& box, const Vec2& centre,
              const Vec2& half, std::string_view what) {
  const auto [x0, y0, x1, y1] = box;
  const double left = centre[0] - half[0], right = centre[0] + half[0], low = centre[1] - half[1],
               high = centre[1] + half[1];
  if (x0 <= left && right <= x1 && y0 <= low && high <= y1) return;
  document.refuse("merging.box",
                  fmt::format("merging.box is [{}, {}, {}, {}]; it must hold {}, which fills "
                              "[{:.4g}, {:.4g}, {:.4g}, {:.4g}]",
                              x0, y0, x1, y1, what, left, low, right, high));
}

}  // namespace

bool covers(const body::BodySettings& body, const Vec2& point) {
  const auto [x, y] = seen_from(point, body.centre);
  const double turned = body.incidence * std::numbers::pi / 180;
  const double along = std::cos(turned) * x - std::sin(turned) * y,
               across = std::sin(turned) * x + std::cos(turned) * y;
  const bool foil = body.shape == body::ShapeKind::naca0012;
  const double a = foil ? 0.45 * *body.chord : *body.radius,
               b = foil ? 0.04 * *body.chord : body.across.value_or(a);
  return std::hypot(along / a, across / b) < 1;
}

void refuse_senseless(const Document& document, const Scene& scene) {
  hold_sizes(document, scene);
  if (scene.initial) hold_initial(document, scene);
  if (scene.body && !scene.initial && speed_of(scene) == 0)
    document.refuse("flow",
                    "nothing moves: a body needs a flow.stream, a [plunge], a motion.spin or "
                    "[initial] vorticity");
}

void refuse_senseless_choice(const Document& document, const Scene& scene) {
  if (scene.initial) hold_pair(document, *scene.initial, scene.cores.sigma_0);
  if (scene.initial && scene.body) hold_distance(document, scene);
  if (scene.body) hold_cores(document, scene);
  hold_steps(document, scene);
  if (scene.body) hold_tips(document, *scene.body);
  if (!scene.merging.box) return;
  if (scene.body)
    hold_box(document, *scene.merging.box, scene.body->centre, half_extent(*scene.body),
             "the body");
  if (scene.initial)
    hold_box(document, *scene.merging.box, scene.initial->centre, half_extent(*scene.initial),
             "the initial vorticity");
}

Vec2 half_extent(const body::BodySettings& body) {
  const double turned = body.incidence * std::numbers::pi / 180;
  const double c = std::abs(std::cos(turned)), s = std::abs(std::sin(turned));
  if (body.shape == body::ShapeKind::naca0012) {
    const double along = 0.5 * *body.chord, across = 0.065 * *body.chord;
    return {c * along + s * across, s * along + c * across};
  }
  const double along = *body.radius, across = body.across.value_or(along);
  return {std::hypot(c * along, s * across), std::hypot(s * along, c * across)};
}

Vec2 half_extent(const vortex::InitialSettings& initial) {
  const double cores = initial.kind == vortex::InitialKind::kirchhoff_ellipse ? 1 : 3;
  return {cores * initial.core + 0.5 * initial.separation.value_or(0), cores * across(initial)};
}

}  // namespace vortree::io
