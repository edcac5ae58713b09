#pragma once

#include "io/scene/document.hpp"
#include "io/scene/scene.hpp"

namespace vortree::io {

/// Fills a scene from a document: known tables and keys only, right types, every value within the
/// rule of its key. What several keys must fulfil together is for parse_scene to see.
/// throws  InputError
[[nodiscard]] Scene read_scene(const Document&, const flow::Methods&);

}  // namespace vortree::io
