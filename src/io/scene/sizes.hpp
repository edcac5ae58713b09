#pragma once

#include "io/scene/document.hpp"
#include "io/scene/scene.hpp"

namespace vortree::io {

/// Refuses numbers of a scene whose products leave the doubles: beyond 1e30 or, but for 0, below
/// 1e-30. Those of [check] and [output], with which nothing is computed, may be any.
/// throws  InputError
void refuse_sizes(const Document& document, const Scene& scene);

}  // namespace vortree::io
