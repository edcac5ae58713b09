#pragma once

#include "io/scene/document.hpp"
#include "io/scene/scene.hpp"

namespace vortree::io {

/// What [check] asks must have something that it can be held against: a reference, a known value,
/// an exact answer, a body, a plunge.
///
/// throws  InputError that names what is missing
void check_asked(const Document& document, const Scene& scene);

}  // namespace vortree::io
