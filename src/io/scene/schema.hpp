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

/// The tables of the flow, of all its methods, and [check], in the order in which they are read.
[[nodiscard]] std::vector<SceneTable> tables(Scene& scene);

/// The same, but of the methods only that which computes it.
[[nodiscard]] std::vector<SceneTable> tables_that_count(Scene& scene);

/// All keys as a table of Markdown: key, default, unit, limits or words, what it is; a row each.
/// The default is "needed" where a table without the key is refused, "chosen" where what else is
/// written makes it, "none" where it may be left open.
[[nodiscard]] std::string page_of_keys(const flow::Methods& methods);

/// A scene of which nothing is written yet.
[[nodiscard]] Scene blank_scene(const flow::Methods& methods);

/// The first key that counts in which two scenes differ, by its dotted name, or "[table]" if one
/// alone has it; or nothing. What may follow from others, as an accuracy chooses it, comes last.
///
/// left_out  says of a dotted name that it does not matter
[[nodiscard]] std::string first_difference(
    const Scene& a, const Scene& b, const std::function<bool(std::string_view name)>& left_out);

}  // namespace vortree::io
