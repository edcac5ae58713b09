#pragma once

#include "bench/sets/point_sets.hpp"

namespace vortree::test {

using bench::every_kind;
using bench::kind_names;
using bench::make_points;
using bench::PointKind;
using bench::PointSet;
using bench::Uniform;

}  // namespace vortree::test
