#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "base/keys.hpp"

// The tables of a scene that mean the same to every method: [flow], [time], [output].

namespace vortree::flow {

/// Order of the time integration: midpoint rule, or the classical Runge-Kutta method.
enum class Scheme { rk2, rk4 };

}  // namespace vortree::flow

namespace vortree {

template <>
inline constexpr std::array<std::string_view, 2> words_of<flow::Scheme>{"rk2", "rk4"};

}  // namespace vortree

namespace vortree::flow {

/// Kinematic viscosity nu >= 0 [L^2/T] and the free stream [L/T]. reynolds = U D/nu gives nu by the
/// body's size D and the stream's speed U (without one, the greatest of the plunge); a loaded scene
/// always has nu.
struct FlowSettings {
  double nu = 0;
  std::array<double, 2> stream{0, 0};
  std::optional<double> reynolds{};
  bool operator==(const FlowSettings&) const = default;
};

struct TimeSettings {
  double dt = 0;
  double end = 0;
  Scheme scheme = Scheme::rk2;
  bool operator==(const TimeSettings&) const = default;
};

/// frames   time between two saved frames; a loaded scene always has it (default: end/14, or dt,
///          in whole steps)
/// fields   times of the pictures, drawn on `window` = [x0, y0, x1, y1] every `field_spacing`; a
///          loaded scene that has pictures has both
/// fields_every, fields_from   more of them: from `fields_from` (the start) on, one after the other
struct OutputSettings {
  double frames = 0;
  std::vector<double> fields{};
  std::optional<double> fields_every{}, fields_from{};
  std::optional<std::array<double, 4>> window{};
  std::optional<double> field_spacing{};
  bool operator==(const OutputSettings&) const = default;

  bool pictures() const { return !fields.empty() || fields_every; }
};

/// Tracers that are released together: `count` of them along line = [x0, y0, x1, y1], from end to
/// end, or evenly around each body, at the distance `around` from its wall [L]; at the first step
/// that is not before t = `from`, and if there is `every`, so often again [T].
struct ReleaseSettings {
  std::optional<std::array<double, 4>> line{};
  std::optional<double> around{};
  int count = 1;
  double from = 0;
  std::optional<double> every{};
  bool operator==(const ReleaseSettings&) const = default;
};

/// Places at which a flow is told in time: `points`, or `count` of them along `line` = [x0, y0, x1,
/// y1], its ends among them; after every step, or at the steps nearest to multiples of `every`.
struct ProbeSettings {
  std::vector<Pair> points{};
  std::optional<std::array<double, 4>> line{};
  int count = 0;
  std::optional<double> every{};
  bool operator==(const ProbeSettings&) const = default;

  std::vector<Pair> places() const;
};

/// More places than this are refused: each has a row a step.
inline constexpr double most_probed = 1e6;

/// throws  Refused for a probe without a place, or with a line of no use; dt is that of the run
void refuse(const std::vector<ProbeSettings>& probes, double dt);

/// Their keys, in the order in which they are read and printed.
[[nodiscard]] std::vector<Key> keys(FlowSettings&);
[[nodiscard]] std::vector<Key> keys(TimeSettings&);
[[nodiscard]] std::vector<Key> keys(OutputSettings&);
[[nodiscard]] std::vector<Key> keys(ReleaseSettings&);
[[nodiscard]] std::vector<Key> keys(ProbeSettings&);

}  // namespace vortree::flow
