#include "io/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "io/files.hpp"
#include "io/quote.hpp"
#include "io/scene_document.hpp"
#include "io/scene_reader.hpp"

namespace vortree::io {
namespace {

constexpr double most_picture_points = 1e8;

void require_reference(const Document& document, const Scene& scene, std::string_view key,
                       const std::optional<std::string>& written) {
  if (!written) return;
  const std::filesystem::path path = reference_path(scene, *written);
  if (!std::filesystem::is_regular_file(path)) {
    document.refuse(
        key, fmt::format("{} is {}; there is no file {}", key, quote(*written), path.string()));
  }
}

void check_output(const Document& document, const Scene& scene) {
  const SceneOutput& output = scene.output;
  if (output.frames < scene.time.dt) {
    document.refuse("output.frames", fmt::format("output.frames is {}; it must be >= time.dt = {}",
                                                 output.frames, scene.time.dt));
  }
  if (!output.fields.empty() && !(output.window && output.field_spacing)) {
    document.refuse("output.fields",
                    "output.fields needs output.window and output.field_spacing beside it");
  }
  if (!output.window) return;
  const auto [x0, y0, x1, y1] = *output.window;
  if (!(x0 < x1 && y0 < y1)) {
    document.refuse("output.window",
                    fmt::format("output.window is [{}, {}, {}, {}]; [x0, y0, x1, y1] with x0 < x1 "
                                "and y0 < y1 was expected",
                                x0, y0, x1, y1));
  }
  if (!output.field_spacing) return;
  const double points = (x1 - x0) * (y1 - y0) / (*output.field_spacing * *output.field_spacing);
  if (points > most_picture_points) {
    document.refuse("output.field_spacing",
                    fmt::format("output.field_spacing is {}; that makes a picture of {:.2g} "
                                "points, {:.0e} at most are drawn",
                                *output.field_spacing, points, most_picture_points));
  }
}

/// What several keys must fulfil together.
void check_together(const Document& document, const Scene& scene) {
  const SceneCores& cores = scene.cores;
  if (cores.sigma_max < cores.sigma_0) {
    document.refuse("cores.sigma_max",
                    fmt::format("cores.sigma_max is {}; it must be >= cores.sigma_0 = {}",
                                cores.sigma_max, cores.sigma_0));
  }
  if (scene.time.end < scene.time.dt) {
    document.refuse("time.end", fmt::format("time.end is {}; it must be >= time.dt = {}",
                                            scene.time.end, scene.time.dt));
  }
  if (scene.initial && !(scene.initial->core > cores.sigma_0)) {
    document.refuse("initial.core",
                    fmt::format("initial.core is {}; it must be > cores.sigma_0 = {}",
                                scene.initial->core, cores.sigma_0));
  }
  if (!scene.body && !scene.initial) {
    document.refuse("", "a scene needs [body] or [initial]; without both there is no vorticity");
  }
  if (scene.check.exact && !scene.initial) {
    document.refuse("check.exact", "check.exact is \"lamb_oseen\"; that needs the table [initial]");
  }
  check_output(document, scene);
  require_reference(document, scene, "check.drag_reference", scene.check.drag_reference);
  require_reference(document, scene, "check.wall_vorticity_reference",
                    scene.check.wall_vorticity_reference);
}

}  // namespace

bool operator==(const Scene& a, const Scene& b) {
  const auto run = [](const Scene& s) {
    return std::tie(s.title, s.seed, s.flow, s.body, s.cores, s.splitting, s.merging, s.initial,
                    s.time, s.velocity, s.output, s.check);
  };
  return run(a) == run(b);
}

Scene parse_scene(std::string_view text, const std::filesystem::path& path,
                  std::span<const std::string> overrides) {
  const Document document(text, path, overrides);
  Scene scene = read_scene(document);
  scene.origin = {path, std::string(text), {overrides.begin(), overrides.end()}};
  if (scene.output.frames == 0) {
    scene.output.frames = std::max(scene.time.end / 14, scene.time.dt);
  }
  check_together(document, scene);
  return scene;
}

Scene load_scene(const std::filesystem::path& path, std::span<const std::string> overrides) {
  return parse_scene(read_text(path), path, overrides);
}

std::filesystem::path reference_path(const Scene& scene, std::string_view written) {
  return scene.origin.path.parent_path() / written;
}

}  // namespace vortree::io
