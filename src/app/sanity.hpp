#pragma once

#include <string>

#include "app/flow_case.hpp"

namespace vortree::app {

/// Why a run cannot go on from these blobs, in words, or nothing:
///
/// - a number that is not finite
/// - more than 2e7 blobs (20 GB, minutes a step), or from 2e4 on more than three times as many as
///   before the step (in the first ten from 1e5 on, 200 times): they multiply faster than they
///   merge
/// - beside a body, sum |gamma| beyond 100 U D (and more for each ten diameters of way). An
///   impulsive start has 4 U D, and a wake gains less than 1 U D a diameter
std::string broken(const vortex::Blobs& blobs, std::size_t before, const FlowCase& flow,
                   double time);

}  // namespace vortree::app
