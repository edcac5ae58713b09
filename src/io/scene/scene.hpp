#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/keys.hpp"
#include "io/input_error.hpp"

namespace vortree::io {

using Vec2 = std::array<double, 2>;

enum class Shape { circle, ellipse, naca0012 };
enum class InitialKind {
  lamb_oseen,
  gaussian_ellipse,
  kirchhoff_ellipse,
  corotating_pair,
  dipole,
  tripole
};
enum class DiffusionKind { core_spreading, random_walk, particle_exchange };
enum class TimeScheme { rk2, rk4 };
enum class VelocityMethod { fmm, boxes, direct };
enum class TreeBuilder { reverse, forward };
enum class PairCores { mean, source, both };
enum class ExactAnswer {
  lamb_oseen,
  kirchhoff_ellipse,
  corotating_pair,
  dipole,
  spinning_cylinder
};

}  // namespace vortree::io

// The words of the TOML file.
namespace vortree {

template <>
inline constexpr std::array<std::string_view, 3> words_of<io::Shape>{"circle", "ellipse",
                                                                     "naca0012"};
template <>
inline constexpr std::array<std::string_view, 6> words_of<io::InitialKind>{
    "lamb_oseen", "gaussian_ellipse", "kirchhoff_ellipse", "corotating_pair", "dipole", "tripole"};
template <>
inline constexpr std::array<std::string_view, 3> words_of<io::DiffusionKind>{
    "core_spreading", "random_walk", "particle_exchange"};
template <>
inline constexpr std::array<std::string_view, 2> words_of<io::TimeScheme>{"rk2", "rk4"};
template <>
inline constexpr std::array<std::string_view, 3> words_of<io::VelocityMethod>{"fmm", "boxes",
                                                                              "direct"};
template <>
inline constexpr std::array<std::string_view, 2> words_of<io::TreeBuilder>{"reverse", "forward"};
template <>
inline constexpr std::array<std::string_view, 3> words_of<io::PairCores>{"mean", "source", "both"};
template <>
inline constexpr std::array<std::string_view, 5> words_of<io::ExactAnswer>{
    "lamb_oseen", "kirchhoff_ellipse", "corotating_pair", "dipole", "spinning_cylinder"};

}  // namespace vortree

namespace vortree::io {

/// Kinematic viscosity nu >= 0 [L^2/T] and the free stream [L/T]. reynolds = U D/nu gives nu by the
/// body's size D and the stream's speed U (without one, the greatest of the plunge); a loaded scene
/// always has nu.
struct SceneFlow {
  double nu = 0;
  Vec2 stream{0, 0};
  std::optional<double> reynolds{};
  bool operator==(const SceneFlow&) const = default;
};

/// A body with `panels` wall elements; the scene has none in free space. An ellipse has the half
/// axes radius and across; NACA 0012 a chord, about whose middle it is centred, and a trailing edge
/// rounded with the radius edge times chord (0.005 if not written; body/outline.hpp). Long axis
/// and chord are turned clockwise by `incidence` degrees from x. Twice the radius, or the chord, is
/// the length that coefficients and the Reynolds number go by.
struct SceneBody {
  Shape shape = Shape::circle;
  std::optional<double> radius{}, across{}, chord{}, edge{};
  double incidence = 0;
  Vec2 centre{0, 0};
  int panels = 520;
  bool operator==(const SceneBody&) const = default;
};

/// The body moves without turning: X(t) = amplitude cos(2 pi frequency t) along a direction. All
/// positions and velocities that a run writes are those in the frame of the body
/// (body/motion.hpp); forces are those that it feels.
struct ScenePlunge {
  double amplitude = 0, frequency = 0;
  Vec2 direction{0, 1};
  bool operator==(const ScenePlunge&) const = default;
};

/// A circle that turns about its centre at a steady rate, anticlockwise, from t = 0 on.
struct SceneMotion {
  double spin = 0;
  bool operator==(const SceneMotion&) const = default;
};

/// sigma_0: core of a blob released at the wall, or of an initial blob. A blob wider than sigma_max
/// splits; further than coarsen_from from the body cores, and the tolerance of mergers, may be
/// (distance/coarsen_from)^(3/4) times as wide (vortex/adapt/coarsening.hpp).
struct SceneCores {
  double sigma_0 = 0;
  double sigma_max = 0;
  std::optional<double> coarsen_from{};
  bool operator==(const SceneCores&) const = default;
};

/// A child has core alpha sigma; `children` of them stand on a ring.
struct SceneSplitting {
  double alpha = 0.7;
  int children = 4;
  bool operator==(const SceneSplitting&) const = default;
};

/// tolerance 0: blobs never merge. reach is in cores; merged sigma^2 <= cap sigma_max^2. Blobs that
/// leave the box [x0, y0, x1, y1] are taken away and accounted for (vortex/blobs/outflow.hpp).
struct SceneMerging {
  double tolerance = 0.02;
  double reach = 2;
  double cap = 1.1;
  std::optional<std::array<double, 4>> box{};
  bool operator==(const SceneMerging&) const = default;
};

/// The vorticity at t = 0 around `centre`, cut into blobs `spacing` sigma_0 apart; those below
/// `faintest` of the strongest are left out.
///
/// lamb_oseen         a Gaussian vortex of width core > sigma_0
/// gaussian_ellipse   half widths core along x and core_across along y
/// kirchhoff_ellipse  uniform vorticity within half axes core and core_across
/// corotating_pair    two Gaussian vortices, each of `circulation`, `separation` apart along x
/// dipole             the same, of opposite signs; it travels along +y
/// tripole            a Gaussian vortex times 1 + perturbation (x^2 - y^2)/core^2
struct SceneInitial {
  InitialKind kind = InitialKind::lamb_oseen;
  double circulation = 1;
  double core = 0;
  double spacing = 1;
  Vec2 centre{0, 0};
  std::optional<double> core_across{}, separation{}, perturbation{};
  double faintest = 1e-12;
  bool operator==(const SceneInitial&) const = default;
};

struct SceneTime {
  double dt = 0;
  double end = 0;
  TimeScheme scheme = TimeScheme::rk2;
  bool operator==(const SceneTime&) const = default;
};

/// order 0: from the tolerance. capacity 0: chosen by the evaluator.
struct SceneVelocity {
  VelocityMethod method = VelocityMethod::fmm;
  double tolerance = 1e-6;
  int order = 0;
  int capacity = 0;
  int finest_level = 31;
  TreeBuilder builder = TreeBuilder::reverse;
  PairCores cores = PairCores::mean;
  bool operator==(const SceneVelocity&) const = default;
};

/// frames   time between two saved frames; a loaded scene always has it (default: end/14, or dt,
///          in whole steps)
/// fields   times of the pictures, drawn on `window` = [x0, y0, x1, y1] every `field_spacing`; a
///          loaded scene that has fields has both
struct SceneOutput {
  double frames = 0;
  std::vector<double> fields{};
  std::optional<std::array<double, 4>> window{};
  std::optional<double> field_spacing{};
  bool operator==(const SceneOutput&) const = default;
};

/// What a finished run is held against; only what is set is checked. check.cpp tells each key.
///
/// *_max, *_rms  largest and root-mean-square deviation allowed
/// *_from        only for T >= this
/// exact         the answer known by heart that a vortex of this kind is measured from
/// *_reference   files as written, relative to the folder of the scene: see reference_path
struct SceneCheck {
  std::optional<std::string> drag_reference{};
  std::optional<double> drag_max{}, drag_rms{}, drag_from{};
  std::optional<std::string> wall_vorticity_reference{};
  std::optional<double> wall_vorticity_max{}, wall_vorticity_rms{}, wall_vorticity_from{};
  std::optional<double> bubble_max{}, bubble_from{};
  std::optional<double> separation_max_deg{}, separation_from{};
  std::optional<double> lift_max{};
  std::optional<double> routes_max{}, routes_from{}, lift_routes_max{};
  std::optional<ExactAnswer> exact{};
  std::optional<double> vorticity_max{}, velocity_max{}, second_moment_max{};
  std::optional<double> circulation_max{}, impulse_max{};
  std::optional<std::string> moments_reference{};
  std::optional<double> quadrupole_max{}, separation_max{};
  std::optional<double> rotation_max{}, speed_max{}, merger_max{}, energy_max{};
  std::optional<double> strouhal{}, strouhal_max{};
  std::optional<double> mean_drag{}, mean_drag_max{};
  std::optional<double> mean_lift{}, mean_lift_max{};
  std::optional<double> shedding_from{};
  std::optional<double> morison_drag{}, morison_drag_max{}, morison_mass{}, morison_mass_max{};
  std::optional<double> theodorsen_max{}, plunge_from{};
  std::optional<double> blobs_max{};
  bool operator==(const SceneCheck&) const = default;
};

/// Where a scene came from, to the letter: enough to load it again. step_chosen: time.dt is not
/// written but follows from the accuracy and from time.end, which it meets.
struct SceneOrigin {
  std::filesystem::path path{};
  std::string text{};
  std::vector<std::string> overrides{};
  bool step_chosen = false;
};

/// core_spreading: wider cores, split and merged; random_walk and particle_exchange: cores stay as
/// they are, in free space only.
struct SceneDiffusion {
  DiffusionKind kind = DiffusionKind::core_spreading;
  bool operator==(const SceneDiffusion&) const = default;
};

/// The method to which cores, splitting, merging, diffusion and velocity belong.
inline constexpr std::string_view vortices = "vortex";

/// One run, fully described. Every key of the TOML file is the member of the same name.
struct Scene {
  std::string title{};
  std::int64_t seed = 1;
  /// What computes the flow, and reads the tables of its own.
  std::string method{vortices};
  /// The error aimed at, by which keys that are not written are chosen: see choice.hpp.
  std::optional<double> accuracy{};
  SceneFlow flow{};
  SceneDiffusion diffusion{};
  std::optional<SceneBody> body{};
  std::optional<ScenePlunge> plunge{};
  std::optional<SceneMotion> motion{};
  SceneCores cores{};
  SceneSplitting splitting{};
  SceneMerging merging{};
  std::optional<SceneInitial> initial{};
  SceneTime time{};
  SceneVelocity velocity{};
  SceneOutput output{};
  SceneCheck check{};
  SceneOrigin origin{};
};

/// The same run: every key agrees; where the scenes were written does not count.
bool operator==(const Scene&, const Scene&);

/// Reads and validates a scene.
///
/// path       a TOML file
/// overrides  `table.key=value` (or `key=value` at top level); value in TOML, bare words are
/// strings; later ones win.
///            A table that the file lacks is created.
/// throws     InputError, one line: `file:line: ...` or `command line: key=value: ...`; unknown
/// tables and keys are errors,
///            so are NaN and infinity and a reference file that is not there
[[nodiscard]] Scene load_scene(const std::filesystem::path& path,
                               std::span<const std::string> overrides = {});

/// The same for a text that is already in memory; `path` names it in errors and is the base of its
/// reference files.
[[nodiscard]] Scene parse_scene(std::string_view text, const std::filesystem::path& path,
                                std::span<const std::string> overrides = {});

/// The scene as TOML with every default written out; parse_scene(resolved(s), s.origin.path) == s.
[[nodiscard]] std::string resolved(const Scene&);

/// Where a reference file of [check] lies: relative to the folder of the scene file.
[[nodiscard]] std::filesystem::path reference_path(const Scene&, std::string_view written);

/// Whether the tables of the vortex method count.
[[nodiscard]] bool by_vortices(const Scene&);

/// The size of a body that coefficients and the Reynolds number go by: twice its radius, or its
/// chord.
[[nodiscard]] double length_of(const SceneBody&);

/// Its perimeter, to 1 % (an ellipse's: 4e-4).
[[nodiscard]] double perimeter_of(const SceneBody&);

/// The radius of NACA 0012's trailing edge, as a share of the chord.
[[nodiscard]] double edge_of(const SceneBody&);

/// The speed that coefficients and the Reynolds number go by: of the stream, or without one the
/// greatest of the plunge; without both that of a wall that spins; 0 without any.
[[nodiscard]] double speed_of(const Scene&);

/// The fastest that a body and its stream meet, or a little more.
[[nodiscard]] double fastest_of(const Scene&);

}  // namespace vortree::io
