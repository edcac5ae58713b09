#pragma once

#include "flow/case.hpp"
#include "sph/settings.hpp"

namespace vortree::sph {

/// Fills in what is not written, D the size of the body:
///
///   spacing    5 accuracy D sqrt(20/Re), at most D/10: an error of the drag of about accuracy, as
///              layers beside the body are thinner by the root of Re
///   region.spacing   spacing
///   levels     so many that the widest spacing is D/5 or more, if the box has room for them
///   zone       D/2, or what holds the rings
///   box        5 D around the body's centre, 7 D on the side to which the stream goes; how far the
///              body extends in place of D if that is more
///   reach      2.8 spacings with degree 2, 3.9 with degree 4 and pair sums
///   time.dt    courant of the finest spacings at the greatest speed
///
/// and of an initial flow that fills the plane, L its wavelength:
///
///   spacing    L sqrt(accuracy/2), an error of the velocity of about accuracy with degree 2
///   levels     1
///   box        a wavelength, from the flow's centre on
///
/// throws  Refused if the spacing is neither written nor chosen
void choose_missing(flow::Case& of, SphSettings& own, const flow::Written& written);

}  // namespace vortree::sph
