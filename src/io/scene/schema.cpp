#include "io/scene/schema.hpp"

#include <iterator>

namespace vortree::io {

std::vector<Key> keys(Scene& scene) {
  std::vector<Key> all = flow::keys(scene);
  all.push_back(key("method", scene.method, anything, "",
                    "what computes the flow, and reads the tables of its own"));
  return all;
}

namespace {

void append(std::vector<SceneTable>& all, std::vector<SceneTable> more) {
  std::ranges::move(more, std::back_inserter(all));
}

}  // namespace

std::vector<SceneTable> tables(Scene& scene) {
  std::vector<SceneTable> all = flow::tables(scene);
  for (flow::AnyMethod& method : scene.methods) append(all, method->tables());
  all.push_back(table("check", scene.check));
  return all;
}

std::vector<SceneTable> tables_that_count(Scene& scene) {
  std::vector<SceneTable> all = flow::tables(scene);
  for (flow::AnyMethod& method : scene.methods)
    if (method->name() == scene.method) append(all, method->tables());
  all.push_back(table("check", scene.check));
  return all;
}

Scene blank_scene(const flow::Methods& methods) {
  Scene blank;
  for (const flow::AnyMethod& method : methods) blank.methods.emplace_back(method->blank());
  if (!methods.empty()) blank.method = methods.front()->name();
  return blank;
}

}  // namespace vortree::io
