#include "io/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "io/files.hpp"
#include "io/quote.hpp"
#include "io/scene_choice.hpp"
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

/// Widths are those of Gaussians that blobs can make up; what a kind needs is there, and no more.
void check_initial(const Document& document, const SceneInitial& initial, double sigma_0) {
  using enum InitialKind;
  const InitialKind kind = initial.kind;
  if (kind != kirchhoff_ellipse)
    for (const auto& [key, width] : {std::pair{"initial.core", std::optional(initial.core)},
                                     std::pair{"initial.core_across", initial.core_across}})
      if (width && !(*width > sigma_0))
        document.refuse(
            key, fmt::format("{} is {}; it must be > cores.sigma_0 = {}", key, *width, sigma_0));
  const auto belongs = [&](const char* key, const std::optional<double>& value, bool wanted) {
    if (value.has_value() != wanted)
      document.refuse(value ? fmt::format("initial.{}", key) : "initial",
                      fmt::format("initial.kind is {}; that {} the key initial.{}",
                                  quote(word(kind)), wanted ? "needs" : "does not have", key));
  };
  belongs("core_across", initial.core_across,
          kind == gaussian_ellipse || kind == kirchhoff_ellipse);
  belongs("separation", initial.separation, kind == corotating_pair || kind == dipole);
  belongs("perturbation", initial.perturbation, kind == tripole);
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
  if (scene.initial) check_initial(document, *scene.initial, cores.sigma_0);
  if (scene.body && scene.body->across.has_value() != (scene.body->shape == Shape::ellipse))
    document.refuse(
        scene.body->across ? "body.across" : "body",
        fmt::format("body.shape is {}; that {} the key body.across", quote(word(scene.body->shape)),
                    scene.body->across ? "does not have" : "needs"));
  if (scene.body && scene.diffusion.kind != DiffusionKind::core_spreading)
    document.refuse("diffusion.kind",
                    fmt::format("diffusion.kind is {}; beside a body vorticity diffuses by "
                                "core_spreading only",
                                quote(word(scene.diffusion.kind))));
  if (!scene.body && !scene.initial) {
    document.refuse("", "a scene needs [body] or [initial]; without both there is no vorticity");
  }
  if (scene.check.exact &&
      !(scene.initial && word(scene.initial->kind) == word(*scene.check.exact)))
    document.refuse("check.exact",
                    fmt::format("check.exact is {0}; that needs the table [initial] of kind {0}",
                                quote(word(*scene.check.exact))));
  if (const auto& box = scene.merging.box; box && !((*box)[0] < (*box)[2] && (*box)[1] < (*box)[3]))
    document.refuse("merging.box",
                    "merging.box is [x0, y0, x1, y1]; x0 < x1 and y0 < y1 were expected");
  if (scene.cores.coarsen_from && !scene.body)
    document.refuse("cores.coarsen_from",
                    "cores.coarsen_from is a distance from the body; there is no [body]");
  check_output(document, scene);
  require_reference(document, scene, "check.drag_reference", scene.check.drag_reference);
  require_reference(document, scene, "check.wall_vorticity_reference",
                    scene.check.wall_vorticity_reference);
  require_reference(document, scene, "check.moments_reference", scene.check.moments_reference);
}

}  // namespace

bool operator==(const Scene& a, const Scene& b) {
  const auto run = [](const Scene& s) {
    return std::tie(s.title, s.seed, s.accuracy, s.flow, s.diffusion, s.body, s.cores, s.splitting,
                    s.merging, s.initial, s.time, s.velocity, s.output, s.check);
  };
  return run(a) == run(b);
}

Scene parse_scene(std::string_view text, const std::filesystem::path& path,
                  std::span<const std::string> overrides) {
  const Document document(text, path, overrides);
  Scene scene = read_scene(document);
  scene.origin = {path, std::string(text), {overrides.begin(), overrides.end()}};
  choose_missing(document, scene);
  if (scene.output.frames == 0) {
    scene.output.frames = std::max(scene.time.end / 14, scene.time.dt);
  }
  check_together(document, scene);
  return scene;
}

Scene load_scene(const std::filesystem::path& path, std::span<const std::string> overrides) {
  return parse_scene(read_text(path), path, overrides);
}

double length_of(const SceneBody& body) {
  return 2 * body.radius;
}

std::filesystem::path reference_path(const Scene& scene, std::string_view written) {
  return scene.origin.path.parent_path() / written;
}

}  // namespace vortree::io
