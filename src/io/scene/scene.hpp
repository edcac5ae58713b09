#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/keys.hpp"
#include "flow/method.hpp"
#include "io/input_error.hpp"

namespace vortree::io {

enum class ExactAnswer {
  lamb_oseen,
  kirchhoff_ellipse,
  corotating_pair,
  dipole,
  spinning_cylinder,
  taylor_green
};

}  // namespace vortree::io

// The words of the TOML file.
namespace vortree {

template <>
inline constexpr std::array<std::string_view, 6> words_of<io::ExactAnswer>{
    "lamb_oseen", "kirchhoff_ellipse", "corotating_pair",
    "dipole",     "spinning_cylinder", "taylor_green"};

}  // namespace vortree

namespace vortree::io {

/// What a finished run is held against; only what is set is checked. check.cpp tells each key.
///
/// *_max, *_rms  largest and root-mean-square deviation allowed
/// *_from        only for T >= this
/// exact         the answer known by heart that a vortex of this kind is measured from
/// *_reference   files as written, relative to the folder of the scene: see reference.hpp
struct CheckSettings {
  std::optional<std::string> drag_reference{};
  std::optional<double> drag_max{}, drag_rms{}, drag_from{}, early_drag_max{};
  std::optional<std::string> wall_vorticity_reference{};
  std::optional<double> wall_vorticity_max{}, wall_vorticity_rms{}, wall_vorticity_from{};
  std::optional<std::string> front_pressure_reference{};
  std::optional<double> front_pressure_max{}, front_pressure_from{};
  std::optional<double> bubble_max{}, bubble_from{};
  std::optional<double> separation_max_deg{}, separation_from{};
  std::optional<std::string> lift_reference{};
  std::optional<double> lift_error_max{}, lift_error_rms{}, lift_from{};
  std::optional<double> lift_max{};
  std::optional<double> routes_max{}, routes_from{}, lift_routes_max{};
  std::optional<ExactAnswer> exact{};
  std::optional<double> vorticity_max{}, velocity_max{}, second_moment_max{};
  std::optional<double> circulation_max{}, impulse_max{};
  std::optional<double> velocity_rms{}, pressure_rms{}, volume_max{}, momentum_max{};
  std::optional<std::string> moments_reference{};
  std::optional<double> quadrupole_max{}, separation_max{};
  std::optional<double> rotation_max{}, speed_max{}, merger_max{}, energy_max{};
  std::optional<double> strouhal{}, strouhal_max{};
  std::optional<double> mean_drag{}, mean_drag_max{};
  std::optional<double> mean_lift{}, mean_lift_max{};
  std::optional<std::vector<double>> mean_drag_each{}, mean_lift_each{}, lift_rms_each{};
  std::optional<double> mean_drag_each_max{}, mean_lift_each_max{}, lift_rms_each_max{};
  std::optional<std::vector<double>> lift_phases_deg{};
  std::optional<double> lift_phases_max_deg{};
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

/// One run, fully described: a flow, the methods that could compute it, one of which does, and what
/// the result is held against.
///
/// method   what computes the flow, and reads the tables of its own
/// methods  all that a scene may name, each with its tables; those of the others are read, and left
///          alone
struct Scene : flow::Case {
  std::string method{};
  flow::Methods methods{};
  CheckSettings check{};
  SceneOrigin origin{};

  [[nodiscard]] const flow::Method& computed_by() const;
};

/// The same run: every key that counts agrees; where the scenes were written does not.
bool operator==(const Scene&, const Scene&);

/// The flow of a scene that is complete, as `resolved` printed it: what it is held against may be
/// elsewhere by now.
/// throws  InputError as parse_scene
[[nodiscard]] flow::Case parse_case(std::string_view resolved, const std::filesystem::path& path,
                                    const flow::Methods& methods);

/// Reads and validates a scene.
///
/// path       a TOML file
/// methods    that it may name; their settings do not count
/// overrides  `table.key=value` (or `key=value` at top level); value in TOML, bare words are
/// strings; later ones win.
///            A table that the file lacks is created; `table={key=value, ...}` sets these keys of
///            it and leaves the others.
/// throws     InputError, one line: `file:line: ...` or `command line: key=value: ...`; unknown
/// tables and keys are errors,
///            so are NaN and infinity, and a reference file that is not there or lacks
///            what is checked
[[nodiscard]] Scene load_scene(const std::filesystem::path& path, const flow::Methods& methods,
                               std::span<const std::string> overrides = {});

/// The same for a text that is already in memory; `path` names it in errors and is the base of its
/// reference files.
[[nodiscard]] Scene parse_scene(std::string_view text, const std::filesystem::path& path,
                                const flow::Methods& methods,
                                std::span<const std::string> overrides = {});

/// The scene as TOML with every default written out, but for the tables of methods that do not
/// compute it; parse_scene(resolved(s), s.origin.path, s.methods) == s.
[[nodiscard]] std::string resolved(const Scene&);

}  // namespace vortree::io
