#include "io/scene/reference.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "body/extent.hpp"
#include "io/files.hpp"
#include "io/quote.hpp"
#include "io/suggestion.hpp"
#include "io/tables/table.hpp"

namespace vortree::io {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
    names.push_back(at->path().filename().string());
  return names;
}

/// A name that differs from the pattern by a number in place of `{reynolds}`.
bool named_by(const std::string& pattern, std::string_view name) {
  const auto at = pattern.find(by_reynolds);
  const std::string_view before = std::string_view(pattern).substr(0, at),
                         after = std::string_view(pattern).substr(at + by_reynolds.size());
  return name.size() > before.size() + after.size() && name.starts_with(before) &&
         name.ends_with(after) &&
         number(name.substr(before.size(), name.size() - before.size() - after.size()));
}

/// Something is there for some Reynolds number.
bool known_for_any(const Scene& scene, std::string_view written) {
  fs::path folder = scene.origin.path.parent_path();
  for (const fs::path& part : fs::path(written)) {
    if (part.string().find(by_reynolds) == std::string::npos) {
      folder /= part;
      continue;
    }
    for (const std::string& name : names_in(folder.empty() ? "." : folder))
      if (named_by(part.string(), name)) return true;
    return false;
  }
  return false;
}

/// Of the first note that says it: what stands behind the last = of `Re = U D/nu = 20, ...`.
std::optional<double> noted_reynolds(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const auto at = line.find("Re = ");
    if (!line.starts_with('#') || at == std::string::npos) continue;
    const std::string words = line.substr(at, line.find_first_of(",;", at) - at);
    if (const auto value = number(words.substr(words.rfind('=') + 1))) return value;
  }
  return {};
}

double reynolds_of(const Scene& scene) {
  if (!scene.body || scene.flow.nu == 0) return 0;
  return flow::speed_of(scene) * body::length_of(*scene.body) / scene.flow.nu;
}

}  // namespace

fs::path reference_path(const Scene& scene, std::string_view written) {
  std::string name(written);
  if (const auto at = name.find(by_reynolds); at != std::string::npos && scene.flow.reynolds)
    name.replace(at, by_reynolds.size(), fmt::format("{}", *scene.flow.reynolds));
  return scene.origin.path.parent_path() / name;
}

bool lacks_reference(const Scene& scene, std::string_view written) {
  std::error_code error;
  return scene.flow.reynolds && written.find(by_reynolds) != std::string_view::npos &&
         !fs::exists(reference_path(scene, written), error) && known_for_any(scene, written);
}

void require_reference_file(const fs::path& path) {
  std::error_code error;
  if (fs::is_regular_file(path, error)) return;
  if (fs::exists(path, error)) require_regular_file(path);
  const std::vector<std::string> names = names_in(folder_of(path));
  const std::vector<std::string_view> known(names.begin(), names.end());
  const std::string_view near = nearest(path.filename().string(), known);
  throw InputError(fmt::format("there is no file {}{}", shortened(path.string(), 100),
                               near.empty() ? "" : fmt::format("; did you mean {}?", near)));
}

flow::Warnings doubt_references(const Scene& scene) {
  flow::Warnings list;
  const double reynolds = reynolds_of(scene);
  const CheckSettings& check = scene.check;
  for (const auto& [key, written] :
       {std::pair{"drag", check.drag_reference}, std::pair{"lift", check.lift_reference},
        std::pair{"wall_vorticity", check.wall_vorticity_reference},
        std::pair{"front_pressure", check.front_pressure_reference}}) {
    if (!written || reynolds == 0 || lacks_reference(scene, *written)) continue;
    const auto noted = noted_reynolds(read_text(reference_path(scene, *written)));
    if (noted && std::abs(*noted / reynolds - 1) > 0.01)
      list.push_back(fmt::format(
          "check.{}_reference = {}: it says Re = {:.6g}, and the flow has {:.6g}; what is held "
          "against it is another flow",
          key, quote(shortened(*written, 60)), *noted, reynolds));
  }
  return list;
}

}  // namespace vortree::io
