#include "app/commands/check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/install_paths.hpp"
#include "app/methods/methods.hpp"
#include "app/say.hpp"
#include "io/quote.hpp"
#include "io/scene/scene.hpp"
#include "io/scene/schema.hpp"

namespace vortree::app {
namespace {

std::string title(const std::filesystem::path& scene) {
  try {
    return io::load_scene(scene, methods()).title;
  } catch (const io::InputError& error) {
    return error.what();
  }
}

}  // namespace

std::string list_cases() {
  const auto scenes = scene_files();
  std::size_t width = 0;
  for (const auto& scene : scenes) width = std::max(width, scene.stem().string().size());
  std::string lines;
  for (const auto& scene : scenes)
    lines += fmt::format("{:<{}}  {}\n", io::printable(scene.stem().string()), width,
                         io::printable(title(scene)));
  return lines;
}

std::string check(const std::string& scene, const std::vector<std::string>& overrides) {
  const io::Scene loaded = io::load_scene(find_scene(scene), methods(), overrides);
  for (const std::string& doubt : warnings(loaded)) say("warning: {}", doubt);
  return io::resolved(loaded);
}

std::string keys() {
  return io::page_of_keys(methods());
}

}  // namespace vortree::app
