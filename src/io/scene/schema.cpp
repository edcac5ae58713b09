#include "io/scene/schema.hpp"

#include <algorithm>
#include <functional>
#include <iterator>

namespace vortree::io {

std::vector<Key> keys(Scene& scene) {
  std::vector<Key> all = flow::keys(scene);
  all.push_back(key("method", scene.method, anything, "",
                    "what computes the flow, and reads the tables of its own"));
  return all;
}

namespace {

/// The tables of the flow, of the methods of which `counts` is true, and [check].
std::vector<SceneTable> tables(Scene& scene,
                               const std::function<bool(const flow::Method&)>& counts) {
  std::vector<SceneTable> all = flow::tables(scene);
  for (flow::AnyMethod& method : scene.methods)
    if (counts(*method)) std::ranges::move(method->tables(), std::back_inserter(all));
  all.push_back(table("check", scene.check));
  return all;
}

}  // namespace

std::vector<SceneTable> tables(Scene& scene) {
  return tables(scene, [](const flow::Method&) { return true; });
}

std::vector<SceneTable> tables_that_count(Scene& scene) {
  return tables(scene, [&](const flow::Method& method) { return method.name() == scene.method; });
}

Scene blank_scene(const flow::Methods& methods) {
  Scene blank;
  for (const flow::AnyMethod& method : methods) blank.methods.emplace_back(method->blank());
  if (!methods.empty()) blank.method = methods.front()->name();
  return blank;
}

}  // namespace vortree::io
