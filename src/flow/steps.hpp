#pragma once

#include "flow/case.hpp"

namespace vortree::flow {

/// More steps are refused: a report of a billion rows fills a disk before it ends, and from 1e16 on
/// a step is lost in the rounding of the time.
inline constexpr double most_steps = 1e9;

/// A time counts as one of the moments k dt if it is so near to one [dt]: the rounding of times
/// written with a dozen digits.
inline constexpr double moment_slack = 1e-6;

/// Whether a run with steps of dt comes to the time t.
[[nodiscard]] bool met(double t, double dt);

/// The last step of a run, 1 or more: the one nearest to time.end.
[[nodiscard]] long last_step(const TimeSettings& time);

/// The moment next to t, as a step; one behind the last if it is later.
[[nodiscard]] long nearest_step(double t, double dt, long last);

/// More pictures than this are refused: a folder of fields is read as a whole.
inline constexpr double most_pictures = 1e5;

/// The times that a scene asks for pictures of: `fields`, and those every `fields_every` until
/// `end`.
[[nodiscard]] std::vector<double> picture_times(const OutputSettings& output, double end);

/// The step for a scene that leaves it open, dt at most: the end is met, and of as many steps as
/// that needs, or up to a fiftieth more, those are taken that meet most of the times of pictures
/// and the interval of frames. A step that meets the end as it is stays, unless it can meet more.
[[nodiscard]] double fitted_step(const Case& of, double dt);

/// The interval of frames that a scene leaves open: end/14, or dt, in whole steps.
[[nodiscard]] double usual_frames(const TimeSettings& time);

/// throws  Refused if a step is longer than the run, or too short to be counted
void refuse_uncountable(const TimeSettings& time);

}  // namespace vortree::flow
