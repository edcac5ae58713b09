#pragma once

#include "flow/initial/initial_flow.hpp"

namespace vortree::flow {

/// An elliptical Gaussian of half widths a along x and b along y,
///
///   omega  = gamma/(pi a b) exp(-x^2/a^2 - y^2/b^2),
///   weight = exp(-x^2/p^2 - y^2/q^2),   p^2 = a^2 - sigma^2, q alike,
///
/// which the cores' own width makes up to the whole again.
/// error   O(exp(-(pi sigma/h)^2)) relative, while a, b > sigma
[[nodiscard]] Patch gaussian(double gamma, double a, double b, Vec2 offset = {});

/// throws  Refused unless the width that `key` has is more than that of the cores
void hold_wider(const std::string& key, double width, double sigma_0);

}  // namespace vortree::flow
