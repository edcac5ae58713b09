#pragma once

#include "io/scene/document.hpp"
#include "io/scene/scene.hpp"

namespace vortree::io {

/// What [check] asks must have something that it can be held against: a known value, an exact
/// answer, a body, a plunge, a reference that is a table with the columns for it.
///
/// throws  InputError that names what is missing
void check_asked(const Document& document, const Scene& scene);

}  // namespace vortree::io
