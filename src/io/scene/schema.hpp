#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/keys.hpp"
#include "io/scene/scene.hpp"

// Every key of a scene, once. Reader, printer, the page of keys and the list of known keys all walk
// these lists, so that none of them can know a key that another does not.

namespace vortree::io {

/// The keys of a table, in the order in which they are read and printed.
[[nodiscard]] std::vector<Key> keys(CheckSettings& check);

/// Those at the top of a scene, outside its tables.
[[nodiscard]] std::vector<Key> keys(Scene& scene);

/// A table of a scene.
///
/// required  a scene without it is refused
/// present   whether the scene has it; only an optional one may be lacking
/// keys      those of the table, which is made, with its defaults, if the scene lacks it
struct SceneTable {
  std::string_view name;
  bool required;
  std::function<bool()> present;
  std::function<std::vector<Key>()> keys;
};

/// All tables, in the order in which they are read and printed.
[[nodiscard]] std::vector<SceneTable> tables(Scene& scene);

/// All keys as a table of Markdown: key, default, unit, limits or words, what it is; a row each.
/// The default is "needed" where a table without the key is refused, "chosen" where what else is
/// written makes it, "none" where it may be left open.
[[nodiscard]] std::string page_of_keys();

}  // namespace vortree::io
