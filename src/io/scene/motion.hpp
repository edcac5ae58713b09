#pragma once

#include <filesystem>

#include "body/settings.hpp"

namespace vortree::io {

/// Fills in the course of a motion from t = 0 to `end`, by its expressions or its file.
///
/// An expression has the variable t, the constant pi, + - * / ^, comparisons, `a ? b : c` and the
/// functions of muParser (sin, cos, tan, asin, ..., exp, log, sqrt, abs, min, max). Its derivatives
/// are those of the polynomials through nine values nearby, so close that what stands between them
/// is met to 1e-9 of the largest, or as close as 2^16 steps are: what bends at once is bent within
/// a few of these.
///
/// folder  of the scene, from where the file's place is seen
/// throws  Refused with the key: an expression that cannot be read or is not finite at some t; a
///         file with too few rows, times that do not ascend, or that ends before the run
///         InputError: a file that cannot be read
void complete_motion(body::MotionSettings& motion, double end, const std::filesystem::path& folder);

}  // namespace vortree::io
