#include "app/install_paths.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>

#include "io/input_error.hpp"

namespace vortree::app {
namespace {

namespace fs = std::filesystem;

constexpr const char *movie = "movie.py", *view = "view.py";

std::vector<fs::path> files_in(const fs::path& folder, std::string_view extension) {
  std::vector<fs::path> files;
  if (!fs::is_directory(folder)) return files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().extension() == extension)
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::string version() {
  return VORTREE_VERSION;
}

fs::path share_folder() {
  if (const char* chosen = std::getenv("VORTREE_SHARE"); chosen && *chosen) return chosen;
  std::error_code unreadable;
  const fs::path program = fs::read_symlink("/proc/self/exe", unreadable);
  const fs::path installed = program.parent_path().parent_path() / "share" / "vortree";
  if (!unreadable && fs::is_directory(installed)) return installed;
  return VORTREE_SOURCE_DIR;
}

std::vector<fs::path> scene_files() {
  return files_in(share_folder() / "cases", ".toml");
}

fs::path find_scene(const std::string& name) {
  std::error_code error;
  const fs::file_type type = fs::status(name, error).type();
  if (type == fs::file_type::none)
    throw io::InputError(fmt::format("{}: {}", name, error.message()));
  if (type != fs::file_type::not_found && type != fs::file_type::directory) return name;
  std::vector<std::string> known;
  for (const auto& scene : scene_files()) {
    if (name == scene.stem() || name == scene.filename()) return scene;
    known.push_back(scene.stem());
  }
  if (type == fs::file_type::directory)
    throw io::InputError(fmt::format("{}: is a folder; a scene is a TOML file", name));
  throw io::InputError(fmt::format("no scene \"{}\"; give a TOML file or one of the cases: {}",
                                   name, fmt::join(known, ", ")));
}

std::vector<fs::path> plot_scripts(std::string_view kind) {
  auto scripts = files_in(share_folder() / "plots", ".py");
  std::erase_if(scripts, [kind](const fs::path& script) {
    const std::string name = script.filename().string();
    return name.front() == '_' || name == movie || name == view || !name.starts_with(kind);
  });
  return scripts;
}

fs::path movie_script() {
  return share_folder() / "plots" / movie;
}

fs::path view_script() {
  return share_folder() / "plots" / view;
}

}  // namespace vortree::app
