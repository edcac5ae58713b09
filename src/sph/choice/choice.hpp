#pragma once

#include "flow/case.hpp"
#include "sph/settings.hpp"

namespace vortree::sph {

/// Fills in what is not written, D the size of the body:
///
///   spacing    5 accuracy D sqrt(20/Re), at most D/10: an error of the drag of about accuracy, as
///              layers beside the body are thinner by the root of Re; of several bodies the least
///   region.spacing   spacing
///   levels     so many that the widest spacing is D/5 or more, D of the shortest body, if the box
///              has room for them
///   zone       D/2, D of the longest body, or what holds the rings
///   box        5 D around the body's centre, 7 D on the side to which the stream goes; how far the
///              body extends in place of D if that is more; around several, what holds the box of
///              each
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
