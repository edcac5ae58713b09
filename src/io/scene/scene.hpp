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
#include "body/settings.hpp"
#include "flow/settings.hpp"
#include "io/input_error.hpp"
#include "vortex/settings.hpp"

namespace vortree::io {

using Vec2 = std::array<double, 2>;

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
inline constexpr std::array<std::string_view, 5> words_of<io::ExactAnswer>{
    "lamb_oseen", "kirchhoff_ellipse", "corotating_pair", "dipole", "spinning_cylinder"};

}  // namespace vortree

namespace vortree::io {

/// What a finished run is held against; only what is set is checked. check.cpp tells each key.
///
/// *_max, *_rms  largest and root-mean-square deviation allowed
/// *_from        only for T >= this
/// exact         the answer known by heart that a vortex of this kind is measured from
/// *_reference   files as written, relative to the folder of the scene: see reference_path
struct CheckSettings {
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
  bool operator==(const CheckSettings&) const = default;
};

/// Where a scene came from, to the letter: enough to load it again. step_chosen: time.dt is not
/// written but follows from the accuracy and from time.end, which it meets.
struct SceneOrigin {
  std::filesystem::path path{};
  std::string text{};
  std::vector<std::string> overrides{};
  bool step_chosen = false;
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
  flow::FlowSettings flow{};
  vortex::DiffusionSettings diffusion{};
  std::optional<body::BodySettings> body{};
  std::optional<body::PlungeSettings> plunge{};
  std::optional<body::MotionSettings> motion{};
  vortex::CoreSettings cores{};
  vortex::SplittingSettings splitting{};
  vortex::MergingSettings merging{};
  std::optional<vortex::InitialSettings> initial{};
  flow::TimeSettings time{};
  vortex::VelocitySettings velocity{};
  flow::OutputSettings output{};
  CheckSettings check{};
  SceneOrigin origin{};
};

/// The same run: every key agrees; where the scenes were written does not count.
bool operator==(const Scene&, const Scene&);

/// Reads and validates a scene.
///
/// path       a TOML file
/// overrides  `table.key=value` (or `key=value` at top level); value in TOML, bare words are
/// strings; later ones win.
///            A table that the file lacks is created; `table={key=value, ...}` sets these keys of
///            it and leaves the others.
/// throws     InputError, one line: `file:line: ...` or `command line: key=value: ...`; unknown
/// tables and keys are errors,
///            so are NaN and infinity, and a reference file that is not there or lacks
///            what is checked
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
[[nodiscard]] double length_of(const body::BodySettings&);

/// Its perimeter, to 1 % (an ellipse's: 4e-4).
[[nodiscard]] double perimeter_of(const body::BodySettings&);

/// The radius of NACA 0012's trailing edge, as a share of the chord.
[[nodiscard]] double edge_of(const body::BodySettings&);

/// The speed that coefficients and the Reynolds number go by: of the stream, or without one the
/// greatest of the plunge; without both that of a wall that spins; 0 without any.
[[nodiscard]] double speed_of(const Scene&);

/// The fastest that a body and its stream meet, or a little more.
[[nodiscard]] double fastest_of(const Scene&);

}  // namespace vortree::io
