#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/keys.hpp"
#include "body/travel.hpp"
#include "flow/initial/settings.hpp"
#include "flow/settings.hpp"

namespace vortree::flow {

/// What a scene says of a flow, whatever method computes it. Every key of the TOML file is the
/// member of the same name.
///
/// body    the first, by whose length coefficients and the Reynolds number go, and from whose
///         centre a method may see all
/// others  those beside it, of the second [[body]] on
/// motion  of all bodies together, as is plunge
/// meetings  of several bodies, once a scene has been read
struct Case {
  std::string title{};
  std::int64_t seed = 1;
  /// The error aimed at, by which a method chooses what is not written.
  std::optional<double> accuracy{};
  FlowSettings flow{};
  std::optional<body::BodySettings> body{};
  std::vector<body::BodySettings> others{};
  std::vector<body::NearestApproach> meetings{};
  std::optional<body::PlungeSettings> plunge{};
  std::optional<body::MotionSettings> motion{};
  std::optional<InitialSettings> initial{};
  TimeSettings time{};
  OutputSettings output{};
  std::vector<ReleaseSettings> tracers{};
  std::vector<ProbeSettings> probes{};
};

/// The keys at the top of a scene that belong to it, and its tables, in the order in which they are
/// read and printed.
[[nodiscard]] std::vector<Key> keys(Case&);
[[nodiscard]] std::vector<SceneTable> tables(Case&);

/// Whether a scene says a key of a table, so that it is not to be chosen.
using Written = std::function<bool(std::string_view table, std::string_view key)>;

/// Fills in flow.nu from flow.reynolds.
/// throws  Refused if both are given and disagree, if neither is, or if there is nothing to go by
void choose_viscosity(Case& of, const Written& written);

/// Fills in output.frames. time.dt must be there by now.
/// throws  Refused for steps that cannot be counted (flow/steps.hpp) or output that cannot be meant
void complete_times(Case& of);

/// throws  Refused for what every number by itself may be, but nobody can mean: a motion without a
///         body, a shape that cannot move so, a direction [0, 0], a body in an initial flow that
///         fills the plane
void refuse_senseless(const Case& of);

/// Fills in meetings. The courses of motions must be there by now.
void complete_meetings(Case& of);

/// throws  Refused for a body at rest in fluid at rest, and for several that turn together,
///         overlap, or come to do so. Courses and meetings must be there.
void refuse_rest(const Case& of);

/// The speed that coefficients and the Reynolds number go by: of the stream, or without one the
/// greatest of the body's centre; without both that of a wall that turns; 0 without any.
[[nodiscard]] double speed_of(const Case& of);
[[nodiscard]] double speed_of_stream(const Case& of);

/// The initial flow, if it is one that fills the plane.
[[nodiscard]] std::optional<PeriodicFlow> periodic_flow_of(const Case& of);

/// What the scene says of each body, the first first.
using BodyList = std::vector<std::reference_wrapper<const body::BodySettings>>;
[[nodiscard]] BodyList every_body(const Case& of);

/// The key of a body's table, as errors name it: body.panels, or of one of several body[1].panels.
[[nodiscard]] std::string key_of_body(const Case& of, std::size_t number, std::string_view key);

/// The bodies as they stand at t = 0.
[[nodiscard]] body::Bodies bodies_of(const Case& of);

/// The fastest that a body and its stream meet, or a little more.
[[nodiscard]] double fastest_of(const Case& of);

/// The period of a plunge, or of the cosine that has the greatest velocity and acceleration of a
/// motion, or rate and spin-up, but no less than a fiftieth of the run: what bends at once has no
/// period. Infinity at rest and at a steady rate.
[[nodiscard]] double period_of(const Case& of);

}  // namespace vortree::flow
