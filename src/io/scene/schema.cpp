#include "io/scene/schema.hpp"

namespace vortree::io {

std::vector<Key> keys(Scene& scene) {
  return {key("title", scene.title, anything, "", "name of the scene"),
          key("seed", scene.seed, not_negative, "", "start of the random numbers"),
          key("method", scene.method, anything, "",
              "what computes the flow; reads the tables of its own: vortex has cores, splitting, "
              "merging, diffusion, initial and velocity"),
          key("accuracy", scene.accuracy,
              {.low = 0, .high = 1, .above_low = true, .words = "it must lie between 0 and 1"}, "",
              "relative error aimed at: chooses what is not written of `cores.sigma_0`, "
              "`cores.sigma_max`, `time.dt`, `merging.*`, `velocity.tolerance` and, beside a body, "
              "`body.panels` and `velocity.cores`")};
}

namespace {

template <class T>
SceneTable always(std::string_view name, bool required, T& table) {
  return {name, required, [] { return true; }, [&table] { return keys(table); }};
}

template <class T>
SceneTable maybe(std::string_view name, std::optional<T>& table) {
  return {name, false, [&table] { return table.has_value(); },
          [&table] { return keys(table ? *table : table.emplace()); }};
}

}  // namespace

std::vector<SceneTable> tables(Scene& scene) {
  return {always("flow", true, scene.flow),
          maybe("body", scene.body),
          maybe("plunge", scene.plunge),
          maybe("motion", scene.motion),
          always("diffusion", false, scene.diffusion),
          always("cores", false, scene.cores),
          always("splitting", false, scene.splitting),
          always("merging", false, scene.merging),
          maybe("initial", scene.initial),
          always("time", true, scene.time),
          always("velocity", false, scene.velocity),
          always("output", false, scene.output),
          always("check", false, scene.check)};
}

}  // namespace vortree::io
