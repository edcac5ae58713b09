#pragma once

#include "flow/case.hpp"
#include "sph/settings.hpp"

namespace vortree::sph {

/// Fills in what is not written, D the size of the body:
///
///   spacing    5 accuracy D sqrt(20/Re), at most D/10: an error of the drag of about accuracy, as
///              layers beside the body are thinner by the root of Re
///   levels     so many that the widest spacing is D/5 or more, if the box has room for them
///   zone       D/2, or what holds the rings
///   box        5 D around the body's centre, 7 D on the side to which the stream goes
///   reach      2.8 spacings with degree 2, 3.9 with degree 4 and pair sums
///   time.dt    courant spacings at the greatest speed
///
/// throws  Refused if the spacing is neither written nor chosen
void choose_missing(flow::Case& of, SphSettings& own, const flow::Written& written);

}  // namespace vortree::sph
