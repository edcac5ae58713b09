#pragma once

#include <array>
#include <concepts>
#include <limits>
#include <string_view>
#include <type_traits>

#include "io/scene/scene.hpp"

// Every key of a scene, once. Reader, printer and the list of known keys all walk these functions,
// so that none of them can know a key that another does not.

namespace vortree::io::schema {

inline constexpr double endless = std::numeric_limits<double>::infinity();

/// What a key must fulfil; `words` say it to the user, after "flow.nu is -1; ".
struct Rule {
  double low = -endless;
  double high = endless;
  bool above_low = false;   ///< low itself is refused
  bool below_high = false;  ///< high itself is refused
  std::string_view words = "";
  bool required = false;

  constexpr bool holds(double value) const {
    return (above_low ? value > low : value >= low) && (below_high ? value < high : value <= high);
  }
};

inline constexpr Rule anything{};
inline constexpr Rule positive{.low = 0, .above_low = true, .words = "it must be > 0"};
inline constexpr Rule not_negative{.low = 0, .words = "it must be >= 0"};

constexpr Rule required(Rule rule) {
  rule.required = true;
  return rule;
}

/// The words of an enumeration, in the order of its values.
template <class E>
inline constexpr std::array<std::string_view, 0> words_of{};
template <>
inline constexpr std::array<std::string_view, 3> words_of<Shape>{"circle", "ellipse", "naca0012"};
template <>
inline constexpr std::array<std::string_view, 6> words_of<InitialKind>{
    "lamb_oseen", "gaussian_ellipse", "kirchhoff_ellipse", "corotating_pair", "dipole", "tripole"};
template <>
inline constexpr std::array<std::string_view, 3> words_of<DiffusionKind>{
    "core_spreading", "random_walk", "particle_exchange"};
template <>
inline constexpr std::array<std::string_view, 2> words_of<TimeScheme>{"rk2", "rk4"};
template <>
inline constexpr std::array<std::string_view, 3> words_of<VelocityMethod>{"fmm", "boxes", "direct"};
template <>
inline constexpr std::array<std::string_view, 2> words_of<TreeBuilder>{"reverse", "forward"};
template <>
inline constexpr std::array<std::string_view, 3> words_of<PairCores>{"mean", "source", "both"};
template <>
inline constexpr std::array<std::string_view, 4> words_of<ExactAnswer>{
    "lamb_oseen", "kirchhoff_ellipse", "corotating_pair", "dipole"};

/// T or const T: the reader walks a scene to be filled, the printer one that is finished.
template <class S, class T>
concept Either = std::same_as<std::remove_const_t<S>, T>;

template <Either<SceneFlow> S, class Visit>
void walk(S& flow, Visit& key) {
  key("nu", flow.nu, Rule{.low = 0, .words = "viscosity must be >= 0"});
  key("stream", flow.stream, anything);
  key("reynolds", flow.reynolds, positive);
}

template <Either<SceneDiffusion> S, class Visit>
void walk(S& diffusion, Visit& key) {
  key("kind", diffusion.kind, anything);
}

template <Either<SceneBody> S, class Visit>
void walk(S& body, Visit& key) {
  key("shape", body.shape, anything);
  key("radius", body.radius, positive);
  key("across", body.across, positive);
  key("chord", body.chord, positive);
  key("edge", body.edge, Rule{.low = 1e-4, .high = 0.02, .words = "it must lie in 1e-4 .. 0.02"});
  key("incidence", body.incidence,
      Rule{.low = -180, .high = 180, .words = "it must lie in -180 .. 180 degrees"});
  key("centre", body.centre, anything);
  key("panels", body.panels, Rule{.low = 8, .words = "a body needs at least 8 panels"});
}

template <Either<ScenePlunge> S, class Visit>
void walk(S& plunge, Visit& key) {
  key("amplitude", plunge.amplitude, required(positive));
  key("frequency", plunge.frequency, required(positive));
  key("direction", plunge.direction, anything);
}

template <Either<SceneCores> S, class Visit>
void walk(S& cores, Visit& key) {
  key("sigma_0", cores.sigma_0, positive);
  key("sigma_max", cores.sigma_max, positive);
  key("coarsen_from", cores.coarsen_from, positive);
}

template <Either<SceneSplitting> S, class Visit>
void walk(S& splitting, Visit& key) {
  constexpr Rule inside{.low = 0,
                        .high = 1,
                        .above_low = true,
                        .below_high = true,
                        .words = "it must lie between 0 and 1"};
  key("alpha", splitting.alpha, inside);
  key("children", splitting.children,
      Rule{.low = 3, .high = 64, .words = "a ring has 3 to 64 children"});
}

template <Either<SceneMerging> S, class Visit>
void walk(S& merging, Visit& key) {
  key("tolerance", merging.tolerance, not_negative);
  key("reach", merging.reach, positive);
  key("cap", merging.cap, positive);
  key("box", merging.box, anything);
}

template <Either<SceneInitial> S, class Visit>
void walk(S& initial, Visit& key) {
  key("kind", initial.kind, anything);
  key("circulation", initial.circulation, required(anything));
  key("core", initial.core, required(positive));
  key("spacing", initial.spacing, positive);
  key("centre", initial.centre, anything);
  key("core_across", initial.core_across, positive);
  key("separation", initial.separation, positive);
  key("perturbation", initial.perturbation, anything);
  key("faintest", initial.faintest,
      Rule{.low = 0, .high = 0.1, .above_low = true, .words = "it must lie between 0 and 0.1"});
}

template <Either<SceneTime> S, class Visit>
void walk(S& time, Visit& key) {
  key("dt", time.dt, positive);
  key("end", time.end, required(positive));
  key("scheme", time.scheme, anything);
}

template <Either<SceneVelocity> S, class Visit>
void walk(S& velocity, Visit& key) {
  key("method", velocity.method, anything);
  key("tolerance", velocity.tolerance,
      Rule{.low = 1e-14, .high = 0.1, .words = "it must lie in 1e-14 .. 0.1"});
  key("order", velocity.order,
      Rule{.low = 0, .high = 100, .words = "it must lie in 0 .. 100; 0: from the tolerance"});
  key("capacity", velocity.capacity, Rule{.low = 0, .words = "it must be >= 0; 0: chosen"});
  key("finest_level", velocity.finest_level,
      Rule{.low = 0, .high = 31, .words = "it must lie in 0 .. 31"});
  key("builder", velocity.builder, anything);
  key("cores", velocity.cores, anything);
}

template <Either<SceneOutput> S, class Visit>
void walk(S& output, Visit& key) {
  key("frames", output.frames, positive);
  key("fields", output.fields, not_negative);
  key("window", output.window, anything);
  key("field_spacing", output.field_spacing, positive);
}

template <Either<SceneCheck> S, class Visit>
void walk(S& check, Visit& key) {
  key("drag_reference", check.drag_reference, anything);
  key("drag_max", check.drag_max, positive);
  key("drag_rms", check.drag_rms, positive);
  key("drag_from", check.drag_from, not_negative);
  key("wall_vorticity_reference", check.wall_vorticity_reference, anything);
  key("wall_vorticity_max", check.wall_vorticity_max, positive);
  key("wall_vorticity_rms", check.wall_vorticity_rms, positive);
  key("wall_vorticity_from", check.wall_vorticity_from, not_negative);
  key("bubble_max", check.bubble_max, positive);
  key("bubble_from", check.bubble_from, not_negative);
  key("separation_max_deg", check.separation_max_deg, positive);
  key("separation_from", check.separation_from, not_negative);
  key("lift_max", check.lift_max, positive);
  key("routes_max", check.routes_max, positive);
  key("routes_from", check.routes_from, not_negative);
  key("lift_routes_max", check.lift_routes_max, positive);
  key("exact", check.exact, anything);
  key("vorticity_max", check.vorticity_max, positive);
  key("velocity_max", check.velocity_max, positive);
  key("second_moment_max", check.second_moment_max, positive);
  key("circulation_max", check.circulation_max, positive);
  key("impulse_max", check.impulse_max, positive);
  key("moments_reference", check.moments_reference, anything);
  key("quadrupole_max", check.quadrupole_max, positive);
  key("separation_max", check.separation_max, positive);
  key("rotation_max", check.rotation_max, positive);
  key("speed_max", check.speed_max, positive);
  key("merger_max", check.merger_max, positive);
  key("energy_max", check.energy_max, positive);
  key("strouhal", check.strouhal, positive);
  key("strouhal_max", check.strouhal_max, positive);
  key("mean_drag", check.mean_drag, positive);
  key("mean_drag_max", check.mean_drag_max, positive);
  key("mean_lift", check.mean_lift, anything);
  key("mean_lift_max", check.mean_lift_max, positive);
  key("shedding_from", check.shedding_from, not_negative);
  key("morison_drag", check.morison_drag, positive);
  key("morison_drag_max", check.morison_drag_max, positive);
  key("morison_mass", check.morison_mass, positive);
  key("morison_mass_max", check.morison_mass_max, positive);
  key("theodorsen_max", check.theodorsen_max, positive);
  key("plunge_from", check.plunge_from, not_negative);
  key("blobs_max", check.blobs_max, positive);
}

/// `visit(name, value, rule)` for the keys at top level, `visit.table(name, value, required)` for
/// the tables; a table that a scene may lack is an optional.
template <Either<Scene> S, class Visit>
void walk(S& scene, Visit& visit) {
  visit("title", scene.title, anything);
  visit("seed", scene.seed, not_negative);
  visit("method", scene.method, anything);
  visit("accuracy", scene.accuracy,
        Rule{.low = 0, .high = 1, .above_low = true, .words = "it must lie between 0 and 1"});
  visit.table("flow", scene.flow, true);
  visit.table("body", scene.body, false);
  visit.table("plunge", scene.plunge, false);
  visit.table("diffusion", scene.diffusion, false);
  visit.table("cores", scene.cores, false);
  visit.table("splitting", scene.splitting, false);
  visit.table("merging", scene.merging, false);
  visit.table("initial", scene.initial, false);
  visit.table("time", scene.time, true);
  visit.table("velocity", scene.velocity, false);
  visit.table("output", scene.output, false);
  visit.table("check", scene.check, false);
}

}  // namespace vortree::io::schema
